#include <algorithm>

#include "emit/artefacts.hpp"

namespace cgw::emit {
namespace {

constexpr std::array eds_formats{Format{"eds", ".eds", true}};
constexpr std::array dcf_formats{Format{"dcf", ".dcf", true}};
constexpr std::array dbc_formats{Format{"dbc", ".dbc", true}};
constexpr std::array image_formats{Format{"bin", "gateway-config.bin"}};
constexpr std::array image_source_formats{Format{"cpp", ""}};
constexpr std::array<std::string_view, 2> eds_options{"--generic", "--eds-name"};
constexpr std::array<std::string_view, 1> named_options{"--eds-name"};
constexpr std::array<std::string_view, 1> image_options{"--no-labels"};
constexpr std::array<std::string_view, 4> image_source_options{"--section", "--align", "--symbol",
                                                               "--no-labels"};

template <typename Row>
const Row* find_row(std::span<const Row> rows, std::string_view name) {
    const auto found =
        std::find_if(rows.begin(), rows.end(), [name](const Row& row) { return row.name == name; });
    return found != rows.end() ? &*found : nullptr;
}

}  // namespace

std::span<const Emitter> all_emitters() {
    static const std::array emitters{
        Emitter{"eds", "electronic data sheet of the configured gateway (CiA 306)", eds_formats, emit_eds,
                eds_options, emit_generic_eds},
        Emitter{"dcf", "device configuration file: the data sheet of this one node (CiA 306)", dcf_formats,
                emit_dcf, named_options},
        Emitter{"dbc", "CAN database: messages and scaled signals of the active PDOs", dbc_formats, emit_dbc,
                named_options},
        Emitter{"pdo-table", "identifiers, cycle times and contents of the 20 PDOs", pdo_table_formats(),
                emit_pdo_table},
        Emitter{"entry-sheet", "what to type into DcDesk 2000, device by device", entry_sheet_formats(),
                emit_entry_sheet},
        Emitter{"image", "configuration image for the gateway runtime", image_formats, emit_image,
                image_options},
        Emitter{"image-source", "the configuration image as C++ source", image_source_formats,
                emit_image_source, image_source_options},
    };
    return emitters;
}

const Emitter* find_emitter(std::string_view name) {
    return find_row(all_emitters(), name);
}

const Format* find_format(const Emitter& emitter, std::string_view name) {
    return name.empty() ? &emitter.formats.front() : find_row(emitter.formats, name);
}

}  // namespace cgw::emit
