// One function per verb; each returns the exit code.
#pragma once

#include "cli/cgw/options.hpp"

namespace cgw::cli {

int check(const CheckOptions& options);
int build(const BuildOptions& options);
int emit(const EmitOptions& options);

}  // namespace cgw::cli
