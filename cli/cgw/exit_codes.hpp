// docs/command-line.md, "Exit codes".
#pragma once

namespace cgw::cli {

inline constexpr int exit_fine = 0;
inline constexpr int exit_findings = 1;  // error findings, stale artefacts, refused image
inline constexpr int exit_usage = 2;
inline constexpr int exit_environment = 3;  // cannot read or write
inline constexpr int exit_internal = 70;

// Of several files the most serious result wins: 70, 3, 1, 0. The numbers happen to be ordered so.
constexpr int worse(int a, int b) {
    return a > b ? a : b;
}

}  // namespace cgw::cli
