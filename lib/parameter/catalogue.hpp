// All rows of both devices, looked up by number or name. Shipped rows come first; a file's own
// catalogues and declarations add rows or fill blanks.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "parameter/row.hpp"

namespace cgw::parameter {

class Catalogue {
  public:
    // The rows are shared, not copied: `shipped` must outlive the catalogue and be sorted by device, number.
    explicit Catalogue(std::span<const Row> shipped);
    Catalogue(const Catalogue&) = delete;
    Catalogue& operator=(const Catalogue&) = delete;

    const Row* find(Device device, std::uint16_t number) const;

    // By canonical name, alias or misprint, ignoring case and blanks before a bracket: "CanOpTPDO5-16ID (11)".
    // An array's name without an index is element (0) (D16).
    const Row* find(Device device, std::string_view name) const;

    // Adds the row or replaces the one of the same number; texts are copied. The pointer stays valid
    // and replaces what find() gave before, so add before anything is looked up for good.
    const Row* put(const Row& row);

    // Every row of the device, ascending.
    std::vector<const Row*> rows(Device device) const;

    // Names for "did you mean": canonical names of settable rows.
    std::vector<std::string_view> names(Device device) const;

  private:
    std::string_view keep(std::string_view text);

    std::span<const Row> shipped_;
    std::deque<Row> added_;
    std::deque<std::string> texts_;
    std::deque<std::vector<std::string_view>> text_lists_;
    std::deque<std::vector<std::uint32_t>> number_lists_;
};

}  // namespace cgw::parameter
