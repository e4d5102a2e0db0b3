// E07: firmware files, and images in them.
#include "diagnostic/rules/firmware.hpp"

namespace cgw::diagnostic::rules {

namespace {

constexpr std::string_view good_file =
    ":020000040801F1\n"
    ":08000000FFFFFFFFFFFFFFFF00\n"
    ":00000001FF\n";

}  // namespace

const Rule firmware_kind{
    .code = "E0701",
    .name = "firmware-kind",
    .level = Level::error,
    .summary = "a firmware file is an ELF program, an Intel HEX file or an S-record file",
    .reference = "",
    .why =
        "An image is put at an address or into a section, and only these files say what stands where. A "
        "plain binary file does not say where it belongs.",
    .example = Example::firmware,
    .bad = "not a firmware file\n",
    .good = good_file};
const Rule record_line{
    .code = "E0702",
    .name = "record-line",
    .level = Level::error,
    .summary = "every line of an Intel HEX or S-record file is one whole record",
    .reference = "",
    .why =
        "A record says how many bytes it has and what they are. One that has fewer, or is of a kind nobody "
        "knows, means that the file was cut, edited or is of another kind.",
    .example = Example::firmware,
    .bad =
        ":020000040801F1\n"
        ":08000000FFFFFFFFFFFFFF00\n"
        ":00000001FF\n",
    .good = good_file};
const Rule record_checksum{
    .code = "E0703",
    .name = "record-checksum",
    .level = Level::error,
    .summary = "the checksum of a record fits its bytes",
    .reference = "",
    .why =
        "A wrong checksum is a byte that has changed since the file was written. A firmware with a wrong "
        "byte is not to be patched but to be built again.",
    .example = Example::firmware,
    .bad =
        ":020000040801F1\n"
        ":08000000FFFFFFFFFFFEFFFF00\n"
        ":00000001FF\n",
    .good = good_file};
const Rule record_address{
    .code = "E0704",
    .name = "record-address",
    .level = Level::error,
    .summary = "each address of an Intel HEX or S-record file is given once",
    .reference = "",
    .why =
        "Where two records give the same address, the programmer decides which one counts. A record that "
        "runs over the end of its addresses goes on at 0 in some programmers and not in others.",
    .example = Example::firmware,
    .bad =
        ":020000040801F1\n"
        ":08000000FFFFFFFFFFFFFFFF00\n"
        ":08000400FFFFFFFFFFFFFFFFFC\n"
        ":00000001FF\n",
    .good =
        ":020000040801F1\n"
        ":08000000FFFFFFFFFFFFFFFF00\n"
        ":08000800FFFFFFFFFFFFFFFFF8\n"
        ":00000001FF\n"};
const Rule record_end{
    .code = "E0705",
    .name = "record-end",
    .level = Level::error,
    .summary = "an Intel HEX or S-record file has its end record at the end, and all records it counts",
    .reference = "",
    .why =
        "The end record is the only sign that a file is whole. What stands behind it is ignored by some "
        "programmers and written by others.",
    .example = Example::firmware,
    .bad =
        ":020000040801F1\n"
        ":08000000FFFFFFFFFFFFFFFF00\n",
    .good = good_file};
const Rule elf_structure{
    .code = "E0706",
    .name = "elf-structure",
    .level = Level::error,
    .summary = "an ELF file is a linked program, and all it speaks of lies inside the file",
    .reference = "",
    .why =
        "A file whose headers point outside of it, or whose parts lie over each other, was cut or damaged. "
        "An object file has no addresses yet: the image goes into the linked program.",
    .example = Example::none,
    .bad = "",
    .good = ""};
const Rule firmware_section{
    .code = "E0707",
    .name = "firmware-section",
    .level = Level::error,
    .summary = "a section for the image exists once and is loaded, read-only data with contents",
    .reference = "",
    .why =
        "A section without contents (NOBITS) is memory that the program clears at its start, and one that "
        "is not loaded never reaches the device. What the program writes to or runs is no place for an "
        "image. "
        "Reserve a section of read-only data, for example filled with 0xFF.",
    .example = Example::none,
    .bad = "",
    .good = ""};
const Rule firmware_address{
    .code = "E0708",
    .name = "firmware-address",
    .level = Level::error,
    .summary = "an address for the image is one that the file can hold",
    .reference = "",
    .why =
        "An ELF program is not made longer: the image replaces bytes of a loaded segment that stand in the "
        "file. Addresses of Intel HEX and S-record files have 32 bits.",
    .example = Example::none,
    .bad = "",
    .good = ""};
const Rule image_alignment{
    .code = "E0709",
    .name = "image-alignment",
    .level = Level::error,
    .summary = "an image begins at a multiple of its alignment, 8 unless --align says otherwise",
    .reference = "",
    .why =
        "The gateway uses the values of the image where they lie. At an odd address many microcontrollers "
        "stop with a fault, or read the value in several steps.",
    .example = Example::none,
    .bad = "",
    .good = ""};
const Rule image_room{
    .code = "E0710",
    .name = "image-room",
    .level = Level::error,
    .summary = "an image fits where it is to stand",
    .reference = "",
    .why =
        "What stands behind the section or segment belongs to something else. Reserve 8 KiB: no "
        "configuration without labels has more.",
    .example = Example::none,
    .bad = "",
    .good = ""};
const Rule image_occupied{
    .code = "E0711",
    .name = "image-occupied",
    .level = Level::error,
    .summary = "an image replaces an earlier image or a reserved area, and nothing else",
    .reference = "",
    .why =
        "Code or data would be destroyed, and the firmware would fail somewhere else than here. An area is "
        "reserved when it is absent from the file or filled with the value that stands for empty, and an "
        "earlier image is known by its first bytes, its size and its CRC-32.",
    .example = Example::firmware,
    .bad =
        ":020000040801F1\n"
        ":04000000004800476D\n"
        ":00000001FF\n",
    .good = good_file};
const Rule image_refused{
    .code = "E0712",
    .name = "image-refused",
    .level = Level::error,
    .summary = "a configuration image passes every test that the gateway makes at its start",
    .reference = "",
    .why =
        "A gateway does not run with a refused image, and nothing in it can be relied on. The number is the "
        "one that firmware shows; docs/image-format.md lists them.",
    .example = Example::none,
    .bad = "",
    .good = ""};
const Rule image_model{
    .code = "E0713",
    .name = "image-model",
    .level = Level::error,
    .summary = "an image that goes into a firmware has the configuration id of its model",
    .reference = "",
    .why =
        "The configuration id is the SHA-256 of the model in the image. Where it is not, the image was "
        "changed by "
        "other means than cgw: what the gateway will do and what the plant's papers say may be two things. A "
        "gateway does not look, so nobody would notice later.",
    .example = Example::none,
    .bad = "",
    .good = ""};
const Rule image_elsewhere{
    .code = "E0714",
    .name = "image-elsewhere",
    .level = Level::error,
    .summary = "a new place for an image is not chosen in a firmware that has an image already",
    .reference = "",
    .why =
        "The program looks in one place. With a mistyped address the firmware would hold two images, and the "
        "device would go on with the earlier one. Where a firmware is to have several, for two gateways or "
        "two regions, --beside says so.",
    .example = Example::none,
    .bad = "",
    .good = ""};

}  // namespace cgw::diagnostic::rules
