#include "diagnostic/rules.hpp"

namespace cgw::diagnostic {

std::string_view to_text(Level level) {
    switch (level) {
        case Level::error:
            return "error";
        case Level::warning:
            return "warning";
        case Level::note:
            return "note";
    }
    return "";
}

namespace rules {

#define CGW_RULE(identifier, code, name, level, summary, reference) \
    const Rule identifier {                                         \
        code, name, Level::level, summary, reference                \
    }

CGW_RULE(file_unreadable, "E0001", "file-unreadable", error, "the file can be opened and read", "");
CGW_RULE(file_too_large, "E0002", "file-too-large", error, "a parameter file or catalogue has at most 4 MiB",
         "");
CGW_RULE(file_not_utf8, "E0003", "file-not-utf8", error, "the file is UTF-8 text without control characters",
         "");
CGW_RULE(toml_syntax, "E0004", "toml-syntax", error, "the file is valid TOML 1.0", "");
CGW_RULE(toml_number_range, "E0005", "toml-number-range", error,
         "a number fits: integers in 64 bits, decimals in a double", "");
CGW_RULE(toml_nesting, "E0006", "toml-nesting", error, "arrays and tables nest at most 64 deep", "");
CGW_RULE(format_missing, "E0007", "format-missing", error,
         "the file says which format it is written in: format = 1", "");
CGW_RULE(format_unsupported, "E0008", "format-unsupported", error, "this cgw reads format 1", "");
CGW_RULE(catalogue_unreadable, "E0009", "catalogue-unreadable", error,
         "every catalogue that the file names can be read", "");

CGW_RULE(key_unknown, "E0101", "key-unknown", error, "every key and table is one that cgw knows", "");
CGW_RULE(key_type, "E0102", "key-type", error, "every key has a value of its type", "");
CGW_RULE(key_missing, "E0103", "key-missing", error, "every required key is there", "");
CGW_RULE(key_value, "E0104", "key-value", error, "the value of a key lies in its range", "");
CGW_RULE(parameter_unknown, "E0105", "parameter-unknown", error,
         "every parameter exists in the catalogue of its device", "D1, D13");
CGW_RULE(parameter_name_mismatch, "E0106", "parameter-name-mismatch", error,
         "number and name of a \"number name\" key belong to the same parameter", "D16");
CGW_RULE(parameter_not_settable, "E0107", "parameter-not-settable", error,
         "only parameters, functions and curves can be set; measurements cannot", "D16");
CGW_RULE(parameter_duplicate, "E0108", "parameter-duplicate", error,
         "a parameter is set once, by any spelling", "");
CGW_RULE(parameter_missing, "E0109", "parameter-missing", error,
         "node numbers, node id and bit rates have no default and must be set", "");
CGW_RULE(value_type, "E0110", "value-type", error, "a parameter's value is a number of its kind", "");
CGW_RULE(value_range, "E0111", "value-range", error, "a parameter's value lies in its range",
         "GWM 11, D6, D17");
CGW_RULE(list_too_long, "E0112", "list-too-long", error, "a list ends with its array", "D16");
CGW_RULE(declaration_invalid, "E0113", "declaration-invalid", error,
         "a declaration says what the catalogue needs to know", "D13");
CGW_RULE(declaration_contradiction, "E0114", "declaration-contradiction", error,
         "a declaration fills blanks of a known parameter and contradicts nothing", "D13");
CGW_RULE(network_node_duplicate, "E0115", "network-node-duplicate", error, "a node is listed once", "");

CGW_RULE(hzm_node_mismatch, "E0201", "hzm-node-mismatch", error,
         "each device knows the other by the node number it has", "GWM 7.1.1, 7.2.1");
CGW_RULE(hzm_bit_rate_mismatch, "E0202", "hzm-bit-rate-mismatch", error,
         "both devices use the same bit rate on the HEINZMANN CAN bus", "GWM 7.1.1, 7.2.1");
CGW_RULE(node_id_duplicate, "E0203", "node-id-duplicate", error,
         "the gateway and its partner have different node ids", "GWM 7.3, D14");
CGW_RULE(node_id_listed, "E0204", "node-id-listed", error,
         "the gateway's node id is not the one of another node in [network]", "GWM 7.2.2");
CGW_RULE(cob_id_reserved, "E0205", "cob-id-reserved", error,
         "an active PDO does not use an identifier reserved for NMT, SYNC, TIME, SDO or heartbeat",
         "GWM 7.3, D33");
CGW_RULE(cob_id_duplicate, "E0206", "cob-id-duplicate", error, "active PDOs have different identifiers",
         "GWM 7.3, D33");
CGW_RULE(cob_id_foreign, "E0207", "cob-id-foreign", error,
         "an active PDO does not use an identifier that a node listed in [network] owns", "D33");
CGW_RULE(heartbeat_partner_missing, "E0208", "heartbeat-partner-missing", error,
         "heartbeat monitoring names the partner it monitors", "GWM 7.2.3, D14");
CGW_RULE(time_too_long, "E0209", "time-too-long", error,
         "a cycle or monitoring time is shorter than 256 governor main cycles", "GWM 7.1.3, D8");
CGW_RULE(switch_bit_range, "E0210", "switch-bit-range", error,
         "a CANopen switch function uses bit 1..16 of RPDO1 word 1, negative when low-active",
         "GWM 7.1.4.1, D27");
CGW_RULE(sensor_channel_range, "E0211", "sensor-channel-range", error,
         "a CANopen sensor uses channel 1..12, the words of RPDO2..4", "GWM 7.1.4.2, D27");
CGW_RULE(engine_stop_over_canopen, "E0212", "engine-stop-over-canopen", error,
         "engine stop is wired and never comes over CANopen", "GWM 7.1.4.1, D34");
CGW_RULE(tpdo_parameter_unknown, "E0213", "tpdo-parameter-unknown", error,
         "a parameter assigned to a TPDO is known with its width and sign", "GWM 7.1.2.2, D13");
CGW_RULE(tpdo_parameter_bit, "E0214", "tpdo-parameter-bit", error,
         "a parameter assigned to a TPDO is not a single bit", "GWM 4.1.2, D13");
CGW_RULE(communication_off, "E0215", "communication-off", error,
         "both devices have their communication with each other switched on", "GWM 7.1.1, 7.2.1, D35");

#undef CGW_RULE

}  // namespace rules

namespace {

using namespace rules;

const Rule* const table[] = {
    &file_unreadable,
    &file_too_large,
    &file_not_utf8,
    &toml_syntax,
    &toml_number_range,
    &toml_nesting,
    &format_missing,
    &format_unsupported,
    &catalogue_unreadable,
    &key_unknown,
    &key_type,
    &key_missing,
    &key_value,
    &parameter_unknown,
    &parameter_name_mismatch,
    &parameter_not_settable,
    &parameter_duplicate,
    &parameter_missing,
    &value_type,
    &value_range,
    &list_too_long,
    &declaration_invalid,
    &declaration_contradiction,
    &network_node_duplicate,
    &hzm_node_mismatch,
    &hzm_bit_rate_mismatch,
    &node_id_duplicate,
    &node_id_listed,
    &cob_id_reserved,
    &cob_id_duplicate,
    &cob_id_foreign,
    &heartbeat_partner_missing,
    &time_too_long,
    &switch_bit_range,
    &sensor_channel_range,
    &engine_stop_over_canopen,
    &tpdo_parameter_unknown,
    &tpdo_parameter_bit,
    &communication_off,
};

}  // namespace

std::span<const Rule* const> all_rules() {
    return table;
}

}  // namespace cgw::diagnostic
