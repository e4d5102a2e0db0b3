#include "diagnostic/rule.hpp"

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

std::string_view language_of(Example example) {
    switch (example) {
        case Example::none:
            return "";
        case Example::parameter_file:
        case Example::copied_file:
        case Example::network:
        case Example::scenario:
            return "toml";
        case Example::table:
        case Example::table_rows:
        case Example::firmware:
        case Example::database:
        case Example::frame_arguments:
        case Example::frame_log:
            return "text";
        case Example::data_sheet:
        case Example::data_sheet_lines:
            return "ini";
        case Example::device_description:
            return "xml";
    }
    return "";
}

}  // namespace cgw::diagnostic
