#include "cli/cgw/verbs.hpp"

namespace cgw::cli {

std::span<const Verb* const> all_verbs() {
    // clang-format off
    static constexpr const Verb* verbs[] = {
        &check_verb,
        &build_verb,
        &emit_verb,
        &list_verb,
        &explain_verb,
        &schema_verb,
        &new_verb,
        &import_table_verb,
        &import_eds_verb,
        &image_verify_verb,
        &image_inspect_verb,
        &image_annotate_verb,
        &image_diff_verb,
        &image_decompile_verb,
        &image_embed_verb,
        &eds_check_verb,
        &eds_fix_verb,
        &eds_diff_verb,
        &convert_verb,
        &bit_timing_verb,
        &network_verb,
        &diff_verb,
        &clone_verb,
        &verify_verb,
        &pdo_verb,
        &encode_verb,
        &decode_verb,
        &hub_verb,
        &simulate_verb,
    };
    // clang-format on
    return verbs;
}

}  // namespace cgw::cli
