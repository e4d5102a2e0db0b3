#include <algorithm>

#include "emit/artefacts.hpp"

namespace cgw::emit {
namespace {

constexpr std::array eds_formats{Format{"eds", ".eds", true}};
constexpr std::array dcf_formats{Format{"dcf", ".dcf", true}};
constexpr std::array xdd_formats{Format{"xdd", ".xdd", true}};
constexpr std::array xdc_formats{Format{"xdc", ".xdc", true}};
constexpr std::array concise_dcf_formats{Format{"bin", ""}};  // of a gateway always without entries
constexpr std::array dbc_formats{Format{"dbc", ".dbc", true}};
constexpr std::array<std::string_view, 1> image_options{"--no-labels"};
constexpr std::array<std::string_view, 2> address_options{"--base", "--align"};
constexpr std::array<std::string_view, 1> assembler_options{"--incbin"};
constexpr std::array image_formats{Format{"bin", default_image_file},
                                   Format{"ihex", "", false, address_options},
                                   Format{"srec", "", false, address_options}};
constexpr std::array image_source_formats{Format{"cpp", "", false, image_options},
                                          Format{"h", "", false, image_options},
                                          Format{"asm", "", false, assembler_options}};
// The partner's programs have build directories of their own: on demand only.
constexpr std::array c_header_formats{Format{"h", ""}};
constexpr std::array structured_text_formats{Format{"st", ""}};
constexpr std::array stx_formats{Format{"stx", ""}};
constexpr std::array python_canopen_formats{Format{"py", ""}};
constexpr std::array points_formats{Format{"csv", ""}};
constexpr std::array<std::string_view, 2> eds_options{"--generic", "--eds-name"};
constexpr std::array<std::string_view, 1> report_options{"--against"};
constexpr std::array<std::string_view, 1> named_options{"--eds-name"};
constexpr std::array<std::string_view, 3> image_source_options{"--section", "--align", "--symbol"};

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
        Emitter{"xdd", "XML device description: the data sheet in XML (CiA 311)", xdd_formats, emit_xdd,
                named_options},
        Emitter{"xdc", "XML configuration of this one node (CiA 311)", xdc_formats, emit_xdc, named_options},
        Emitter{"concise-dcf", "what a CANopen manager writes into this node at boot (CiA 302, 1F22h)",
                concise_dcf_formats, emit_concise_dcf},
        Emitter{"dbc", "CAN database: messages and scaled signals of the active PDOs", dbc_formats, emit_dbc,
                named_options},
        Emitter{"pdo-table", "identifiers, cycle times and contents of the 20 PDOs", pdo_table_formats(),
                emit_pdo_table},
        Emitter{"entry-sheet", "what to type into DcDesk 2000, device by device", entry_sheet_formats(),
                emit_entry_sheet},
        Emitter{"report", "the plant on one page: verdict, buses, PDOs, findings, entry sheets",
                report_formats(), emit_report, report_options},
        Emitter{"image", "configuration image for the gateway runtime: binary, Intel HEX, S-record",
                image_formats, emit_image, image_options},
        Emitter{"image-source", "the configuration image as C++ source, C header or assembler source",
                image_source_formats, emit_image_source, image_source_options},
        Emitter{"c-header", "for the partner's program: PDOs and scaling in C99 and C++", c_header_formats,
                emit_c_header},
        Emitter{"structured-text", "for the partner's program: the same in IEC 61131-3 Structured Text",
                structured_text_formats, emit_structured_text},
        Emitter{"stx", "for the partner's program: calls of Jetter's CANopen STX API", stx_formats, emit_stx},
        Emitter{"python-canopen", "for the partner's program: Python, with and without its library canopen",
                python_canopen_formats, emit_python_canopen},
        Emitter{"points", "for the partner's program: list of points for SCADA systems", points_formats,
                emit_points},
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
