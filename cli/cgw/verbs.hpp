// The rows of the verb table, one file verb_….cpp each.
#pragma once

#include "cli/cgw/command.hpp"

namespace cgw::cli {

extern const Verb check_verb;
extern const Verb build_verb;
extern const Verb emit_verb;
extern const Verb list_verb;
extern const Verb explain_verb;
extern const Verb schema_verb;
extern const Verb new_verb;
extern const Verb import_table_verb;
extern const Verb import_eds_verb;
extern const Verb bit_timing_verb;
extern const Verb network_verb;
extern const Verb diff_verb;
extern const Verb clone_verb;
extern const Verb image_verify_verb;
extern const Verb image_inspect_verb;
extern const Verb image_annotate_verb;
extern const Verb image_decompile_verb;
extern const Verb image_diff_verb;
extern const Verb image_embed_verb;
extern const Verb eds_check_verb;
extern const Verb eds_fix_verb;
extern const Verb eds_diff_verb;
extern const Verb convert_verb;
extern const Verb verify_verb;
extern const Verb pdo_verb;
extern const Verb encode_verb;
extern const Verb decode_verb;
extern const Verb hub_verb;
extern const Verb simulate_verb;

}  // namespace cgw::cli
