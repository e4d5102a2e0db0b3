// Which parameter a key of [governor.parameters] or [gateway.parameters] means.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "input/context.hpp"

namespace cgw::input {

// A key taken apart: "401", "CanMyNodeNumber" or "401 CanMyNodeNumber".
struct Spelling {
    std::optional<std::uint16_t> number;  // absent in a bare name, and when it does not fit
    std::string_view number_text;         // digits in front, as typed
    std::string_view name;
};

Spelling take_apart(std::string_view key);

// nullptr when the key means nothing, or two different things (D2, D10, D16).
const parameter::Row* resolve_silently(const parameter::Catalogue& catalogue, parameter::Device device,
                                       std::string_view key);

// "401 is CanMyNodeNumber, but CanCMNodeNumber is 403": for a number and a name that do not belong together
// and of which the device knows at least one.
std::string mismatch_message(const parameter::Catalogue& catalogue, parameter::Device device,
                             std::uint16_t number, std::string_view name);

// resolve_silently() with findings; suggestions stop after some dozens, so that a file of nonsense stays
// cheap.
class KeyResolver {
  public:
    KeyResolver(Context& context, parameter::Device device) : context_(context), device_(device) {}

    // The table whose keys follow: what it sets by another key was not meant by an unknown one.
    void enter(const toml::Node& table);

    // After a finding about a number that exists, or about a name or number that is nearly one, what was
    // probably meant is rejected in the device's set.
    const parameter::Row* resolve(const toml::Entry& entry);

    // For a key that means something, but not what it should: the parameters nobody can do without that are
    // one character away are rejected, unless the table sets them.
    void reject_needed_neighbours(const toml::Entry& entry);

  private:
    using Rows = std::vector<const parameter::Row*>;

    void report_mismatch(const toml::Entry& entry, const Spelling& spelling);
    void report_unknown(const toml::Entry& entry, const Spelling& spelling);
    std::string help_for_unknown(const toml::Entry& entry, const Spelling& spelling,
                                 const parameter::Row* foreign);
    const parameter::Row* in_other_device(const Spelling& spelling) const;
    std::string nearest(std::string_view name, bool is_thorough);
    Rows neighbours(const toml::Entry& entry, bool is_thorough);
    const parameter::Row* likeliest(const Rows& rows) const;
    Rows needed() const;
    bool is_written(std::uint16_t number);

    Context& context_;
    parameter::Device device_;
    std::vector<std::string_view> names_;
    const toml::Node* table_ = nullptr;
    std::optional<std::set<std::uint16_t>> written_;  // what table_ sets; made when it is first asked for
    int suggestions_left_ = 50;
};

}  // namespace cgw::input
