// Inside the traffic room: the formats of render.hpp, one file each.
#pragma once

#include "traffic/render.hpp"

namespace cgw::traffic {

std::string text_frame(const Told& told);
std::string text_summary(const Audit& audit, std::span<const diagnostic::Diagnostic> findings);

std::string json_head(const Subject& subject);
std::string json_frame(const Told& told);
std::string json_foot(const Audit& audit, std::span<const diagnostic::Diagnostic> findings);

std::string csv_head(const Subject& subject);
std::string csv_frame(const Told& told);

}  // namespace cgw::traffic
