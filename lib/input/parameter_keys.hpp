// Which parameter a key of [governor.parameters] or [gateway.parameters] means.
#pragma once

#include <cstdint>
#include <optional>
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

// The same with findings; suggestions stop after some dozens, so that a file of nonsense stays cheap.
class KeyResolver {
  public:
    KeyResolver(Context& context, parameter::Device device) : context_(context), device_(device) {}

    // After a finding about a number that exists, or about a name or number that is nearly one, what was
    // probably meant is rejected in the device's set.
    const parameter::Row* resolve(const toml::Entry& entry);

  private:
    void report_mismatch(const toml::Entry& entry, const Spelling& spelling);
    void report_unknown(const toml::Entry& entry, const Spelling& spelling);
    std::string help_for_unknown(const Spelling& spelling);
    const parameter::Row* in_other_device(const Spelling& spelling) const;

    Context& context_;
    parameter::Device device_;
    std::vector<std::string_view> names_;
    int suggestions_left_ = 50;
};

}  // namespace cgw::input
