// One function per cell: reads its value, whose type is right already, into the draft or reports why not.
#pragma once

#include "catalogue/cells.hpp"

namespace cgw::catalogue {

void read_number(const toml::Node& value, Draft& draft, const Reporter& report);
void read_count(const toml::Node& value, Draft& draft, const Reporter& report);
void read_last(const toml::Node& value, Draft& draft, const Reporter& report);
void read_list_end(const toml::Node& value, Draft& draft, const Reporter& report);
void read_name(const toml::Node& value, Draft& draft, const Reporter& report);
void read_aliases(const toml::Node& value, Draft& draft, const Reporter& report);
void read_misprints(const toml::Node& value, Draft& draft, const Reporter& report);
void read_kind(const toml::Node& value, Draft& draft, const Reporter& report);
void read_text(const toml::Node& value, Draft& draft, const Reporter& report);
void read_used(const toml::Node& value, Draft& draft, const Reporter& report);
void read_bits(const toml::Node& value, Draft& draft, const Reporter& report);
void read_values(const toml::Node& value, Draft& draft, const Reporter& report);
void read_section(const toml::Node& value, Draft& draft, const Reporter& report);
void read_unit(const toml::Node& value, Draft& draft, const Reporter& report);
void read_level(const toml::Node& value, Draft& draft, const Reporter& report);
void read_range(const toml::Node& value, Draft& draft, const Reporter& report);
void read_choices(const toml::Node& value, Draft& draft, const Reporter& report);
void read_pages(const toml::Node& value, Draft& draft, const Reporter& report);
void read_base(const toml::Node& value, Draft& draft, const Reporter& report);
void read_decimal(const toml::Node& value, Draft& draft, const Reporter& report);
void read_width(const toml::Node& value, Draft& draft, const Reporter& report);
void read_bit(const toml::Node& value, Draft& draft, const Reporter& report);
void read_signed(const toml::Node& value, Draft& draft, const Reporter& report);
void read_internal(const toml::Node& value, Draft& draft, const Reporter& report);
void read_external(const toml::Node& value, Draft& draft, const Reporter& report);

}  // namespace cgw::catalogue
