// Inside the emit room: the functions behind the emitter table. Options are those of emitter.hpp; a format
// the emitter does not have is taken for its first.
#pragma once

#include "emit/emitter.hpp"

namespace cgw::emit {

base::Bytes emit_eds(const Plant& plant, const Options& options);
base::Bytes emit_generic_eds(const Origin& origin, const Options& options);
base::Bytes emit_dcf(const Plant& plant, const Options& options);
base::Bytes emit_xdd(const Plant& plant, const Options& options);
base::Bytes emit_xdc(const Plant& plant, const Options& options);
base::Bytes emit_concise_dcf(const Plant& plant, const Options& options);
base::Bytes emit_dbc(const Plant& plant, const Options& options);
base::Bytes emit_pdo_table(const Plant& plant, const Options& options);
base::Bytes emit_entry_sheet(const Plant& plant, const Options& options);
base::Bytes emit_report(const Plant& plant, const Options& options);
base::Bytes emit_image(const Plant& plant, const Options& options);
base::Bytes emit_image_source(const Plant& plant, const Options& options);
base::Bytes emit_c_header(const Plant& plant, const Options& options);
base::Bytes emit_python_canopen(const Plant& plant, const Options& options);
base::Bytes emit_structured_text(const Plant& plant, const Options& options);
base::Bytes emit_stx(const Plant& plant, const Options& options);
base::Bytes emit_points(const Plant& plant, const Options& options);

std::span<const Format> pdo_table_formats();
std::span<const Format> entry_sheet_formats();
std::span<const Format> report_formats();

}  // namespace cgw::emit
