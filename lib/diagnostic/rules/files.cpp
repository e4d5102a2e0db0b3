// E00: the file as such.
#include "diagnostic/rules/files.hpp"

namespace cgw::diagnostic::rules {

const Rule file_unreadable{
    .code = "E0001",
    .name = "file-unreadable",
    .level = Level::error,
    .summary = "the file can be opened and read",
    .reference = "",
    .why =
        "Nothing can be said about a file that cannot be read. The message gives the reason of the "
        "operating system: most often a name typed wrong, or the wrong directory.",
    .example = Example::none,
    .bad = "",
    .good = ""};
const Rule file_too_large{
    .code = "E0002",
    .name = "file-too-large",
    .level = Level::error,
    .summary = "a text file has at most 4 MiB, an EDS or DCF 32 MiB",
    .reference = "",
    .why =
        "A complete parameter file has some kilobytes, an EDS of fifty thousand objects 12 MiB. What is "
        "larger "
        "is something else, given by mistake, and is not worth the memory it would take.",
    .example = Example::none,
    .bad = "",
    .good = ""};
const Rule file_not_utf8{
    .code = "E0003",
    .name = "file-not-utf8",
    .level = Level::error,
    .summary = "the file is UTF-8 text without control characters",
    .reference = "",
    .why =
        "Older editors save letters with dots and accents in the code page of one country, and the next "
        "computer "
        "shows something else. Save the file as UTF-8; plain English text is UTF-8 already.",
    .example = Example::none,
    .bad = "",
    .good = ""};
const Rule toml_syntax{
    .code = "E0004",
    .name = "toml-syntax",
    .level = Level::error,
    .summary = "the file is valid TOML 1.0",
    .reference = "",
    .why =
        "What stands after a mistake of syntax cannot be told apart with certainty, so cgw reads nothing "
        "of such a file. A decimal takes a point, text takes quotation marks, a list takes commas.",
    .bad =
        "[gateway.parameters]\n"
        "427 = 5,0\n",
    .good =
        "[gateway.parameters]\n"
        "427 = 5\n"};
const Rule toml_number_range{
    .code = "E0005",
    .name = "toml-number-range",
    .level = Level::error,
    .summary = "a number fits: integers in 64 bits, decimals in a double",
    .reference = "",
    .why =
        "A number this large is a key held down or two lines run together. Other readers of TOML cut it "
        "down to another number without a word; the engine would run with that.",
    .bad =
        "[gateway.parameters]\n"
        "429 = 80000000000000000000\n",
    .good =
        "[gateway.parameters]\n"
        "429 = 800\n"};
const Rule toml_nesting{
    .code = "E0006",
    .name = "toml-nesting",
    .level = Level::error,
    .summary = "arrays and tables nest at most 64 deep",
    .reference = "",
    .why =
        "No parameter needs more than one level of brackets. A file with dozens of them is damaged or was "
        "not made by a person.",
    .bad =
        "[network]\n"
        "nodes = [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[2]]]]]]]]]]]]]]]]]]]]]"
        "]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]\n",
    .good =
        "[network]\n"
        "nodes = [2]\n"};
const Rule format_missing{
    .code = "E0007",
    .name = "format-missing",
    .level = Level::error,
    .summary = "the file says which format it is written in: format = 1",
    .reference = "",
    .why =
        "The line tells every later cgw how the file is meant, so that a file kept for years with the "
        "plant's papers is still read as it was written.",
    .bad = "# format = 1\n",
    .good = "format = 1\n"};
const Rule format_unsupported{
    .code = "E0008",
    .name = "format-unsupported",
    .level = Level::error,
    .summary = "this cgw reads format 1",
    .reference = "",
    .why =
        "A file of a later format may say things that this cgw does not know. Reading the rest and "
        "leaving those out would give a configuration that nobody asked for.",
    .bad = "format = 2\n",
    .good = "format = 1\n"};
const Rule catalogue_unreadable{
    .code = "E0009",
    .name = "catalogue-unreadable",
    .level = Level::error,
    .summary = "every catalogue that the file names can be read",
    .reference = "",
    .why =
        "A catalogue says which measurements this governor has and how wide they are. Without it words "
        "would be left out of the TPDOs and the later ones would move. Names are relative to the "
        "parameter file.",
    .bad = "catalogue = [\"torq.toml\"]\n",
    .good = "catalogue = [\"torque.toml\"]\n"};

}  // namespace cgw::diagnostic::rules
