// All rows of both devices, looked up by number or name. Shipped rows come first; a file's own
// catalogues and declarations add rows or fill blanks.
//
// How a key of the parameter file is resolved (D2, D3, D10, D16):
//   `409`, `401`              find(device, number), else find_misprint(device, number, ""): take that row,
//   with a note `CanMyNodeNumber`         find(device, name); aliases are silent
//   `"409 CanBaudrate"`       find(device, number) and find(device, name) agree: fine; otherwise
//                             find_misprint(device, number, name): take that row, with a note; else an error
#pragma once

#include <array>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "parameter/row.hpp"

namespace cgw::parameter {

class Catalogue {
  public:
    // The rows are shared, not copied: `shipped` must outlive the catalogue and be sorted by device,
    // program, number.
    explicit Catalogue(std::span<const Row> shipped);
    Catalogue(const Catalogue&) = delete;
    Catalogue& operator=(const Catalogue&) = delete;

    // In the application, which is what parameter files are about; say the program for the bootloader (D1).
    const Row* find(Device device, std::uint16_t number) const;
    const Row* find(Device device, Program program, std::uint16_t number) const;

    // By canonical name or alias, ignoring case and blanks before a bracket: "CanOpTPDO5-16ID (11)".
    // An array's name without an index is element (0) (D16). When a name and an alias compete, the row that
    // was there first wins; the reader of catalogues refuses such rows.
    const Row* find(Device device, std::string_view name) const;
    const Row* find(Device device, Program program, std::string_view name) const;

    // The row that a misprint of the manuals means: "409 CanBaudrate" is 416 (D2), "4901 ChanType_Setp1Ext"
    // is 4901 (D10). `name` as typed (case and blanks as above), or "" for a bare number; a bare number that
    // has a row of its own is no misprint. nullptr when this is none of the known ones.
    const Row* find_misprint(Device device, std::uint16_t number, std::string_view name) const;

    // Adds the row or replaces the one of the same device, program and number; texts are copied. The pointer
    // stays valid and replaces what find() gave before, so add before anything is looked up for good.
    const Row* put(const Row& row);

    // Every row of the device's application, ascending.
    const std::vector<const Row*>& rows(Device device) const { return rows(device, Program::application); }
    const std::vector<const Row*>& rows(Device device, Program program) const {
        return by_number_[index_of(device, program)];
    }

    // The rows that came or changed through put(), by device, program and number: what the file's own
    // catalogues and declarations contribute.
    std::vector<const Row*> added() const;

    // Names for "did you mean": canonical names of settable rows, and the bare names of arrays.
    std::vector<std::string_view> names(Device device) const;

  private:
    struct NameHash {
        std::size_t operator()(std::string_view name) const;
    };
    struct NameEqual {
        bool operator()(std::string_view a, std::string_view b) const;
    };
    using NameIndex = std::unordered_map<std::string_view, const Row*, NameHash, NameEqual>;

    static std::size_t index_of(Device device, Program program) {
        return 2 * static_cast<std::size_t>(device) + static_cast<std::size_t>(program);
    }
    std::string_view keep(std::string_view text);
    std::span<const std::string_view> keep(std::span<const std::string_view> texts);
    std::span<const NamedBit> keep(std::span<const NamedBit> bits);
    std::span<const NamedValue> keep(std::span<const NamedValue> values);
    template <typename Visit>
    static void each_name(const Row& row, Visit visit);
    void index_names(const Row& row);
    void forget_names(const Row& row);

    std::array<std::vector<const Row*>, 4> by_number_;  // two devices, two programs each
    std::array<NameIndex, 4> by_name_;
    std::deque<Row> added_;
    std::deque<std::string> texts_;
    std::deque<std::vector<std::string_view>> text_lists_;
    std::deque<std::vector<std::uint32_t>> number_lists_;
    std::deque<std::vector<NamedBit>> bit_lists_;
    std::deque<std::vector<NamedValue>> value_lists_;
};

// Name of the array a row is an element of: "CanOpTPDO5-16ID" for `CanOpTPDO5-16ID(3)`; else the whole name.
std::string_view array_name(const Row& row);

}  // namespace cgw::parameter
