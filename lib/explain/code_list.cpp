#include <fmt/format.h>

#include "base/abort_codes.hpp"
#include "catalogue/errors.hpp"
#include "catalogue/objects.hpp"
#include "explain/lists.hpp"
#include "explain/wording.hpp"

namespace cgw::explain {

namespace {

using catalogue::ErrorDescription;
using parameter::Catalogue;
using parameter::Device;
using parameter::Program;
using parameter::Row;

// "2005h bit 1"; the bootloader has no object dictionary.
std::string seen_in(const ErrorDescription& error) {
    const auto bit = catalogue::find_object_bit(error.number);
    if (!bit || error.program == Program::bootloader || error.number == 0) {
        return "";
    }
    return bit->sub == 0 ? fmt::format("{} bit {}", object_text(bit->index), bit->bit)
                         : fmt::format("{} bit {}", object_text(bit->index, bit->sub), bit->bit);
}

// Every number of the row's device that shows an error: what 3000.. and 12411.. hold, and the codes beside
// them.
void append_errors(Table& table, const Catalogue& catalogue, Device device, Program program) {
    for (const ErrorDescription& error : catalogue::shipped_errors()) {
        if (!error.shown_by(device) || error.program != program) {
            continue;
        }
        const Row* row = catalogue.find(device, program, error.number);
        const bool numbered = row != nullptr;
        table.rows.push_back({
            fmt::format("errors of the {}", program_text(device, program)),
            std::string(to_text(device)),
            std::string(to_text(program)),
            numbered ? fmt::format("{}", error.number) : std::string(error.key),
            numbered ? std::string(row->name) : "",
            seen_in(error),
            numbered ? std::string(row->text) : std::string(error.cause.front()),
            std::string(error.section),
        });
    }
}

void append_abort_codes(Table& table) {
    for (const base::AbortCodeRow& row : base::abort_codes()) {
        table.rows.push_back({
            "SDO abort codes",
            row.gateway.empty() ? "" : "gateway",
            row.gateway.empty() ? "" : "application",
            fmt::format("0x{:08X}", row.code),
            row.gateway.empty() ? "" : "sent by the gateway",
            "",
            std::string(row.meaning),
            "CiA 301",
        });
    }
}

}  // namespace

Table code_list(const Catalogue& catalogue, std::optional<Device> device) {
    Table table{"codes", true, {}, {}};
    table.columns = {
        {"kind", "", in_data},    {"device", "", in_data},
        {"program", "", in_data}, {"code", "code"},
        {"name", "name"},         {"seen_in", "seen in"},
        {"text", "meaning"},      {"source", "source", in_page | in_data},
    };
    for (const Device one : {Device::governor, Device::gateway}) {
        for (const Program program : {Program::application, Program::bootloader}) {
            if (!device || *device == one) {
                append_errors(table, catalogue, one, program);
            }
        }
    }
    if (!device || *device == Device::gateway) {
        append_abort_codes(table);
    }
    return table;
}

}  // namespace cgw::explain
