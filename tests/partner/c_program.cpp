#include "partner/c_program.hpp"

#include <fmt/format.h>

namespace cgw::test {
namespace {

using fmt::arg;
using signals::Signal;

std::string lowered(std::string text) {
    for (char& c : text) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return text;
}

constexpr std::string_view opening =
    "#include \"{header}\"\n"
    "#include <stdio.h>\n"
    "#include <stdlib.h>\n"
    "#include <string.h>\n"
    "\n"
    "static void print_bytes(const char *name, const uint8_t *bytes, unsigned length)\n"
    "{{\n"
    "    unsigned i;\n"
    "    printf(\"%s \", name);\n"
    "    for (i = 0; i < length; ++i) {{\n"
    "        printf(\"%02X\", (unsigned)bytes[i]);\n"
    "    }}\n"
    "    printf(\" \");\n"
    "}}\n";

std::string decoding(const std::string& type, const signals::Frame& frame) {
    std::string text = fmt::format(
        "static int decode_{type}(uint32_t cob_id, const uint8_t *data, unsigned length)\n"
        "{{\n"
        "    {type} pdo;\n"
        "    if (!{type}_take(&pdo, cob_id, data, length)) {{\n"
        "        return 0;\n"
        "    }}\n"
        "    if ({type}_take(&pdo, cob_id, data, length - 1u) || {type}_take(&pdo, cob_id + 1u, data, "
        "length)) {{\n"
        "        exit(3);\n"
        "    }}\n",
        arg("type", type));
    for (const Signal& signal : frame.signals) {
        const auto line = [&](std::string_view format, std::string_view values) {
            text += fmt::format("    printf(\"{} {} {}\\n\", {});\n", frame.name, signal.name, format,
                                fmt::format(fmt::runtime(values), arg("t", type), arg("n", signal.name),
                                            arg("bit", signal.first_bit)));
        };
        if (!signal.values.empty()) {
            line("%d %s", "{t}_bit(&pdo, {bit}u), {t}_ison_{n}(&pdo) ? \"on\" : \"off\"");
        } else if (signal.is_bit()) {
            line("%d", "{t}_bit(&pdo, {bit}u)");
        } else if (signal.scaled) {
            line("%d %.17g", "(int){t}_raw_{n}(&pdo), {t}_value_{n}(&pdo)");
        } else {
            line("%d", "(int){t}_raw_{n}(&pdo)");
        }
    }
    return text + "    return 1;\n}\n";
}

std::string encoding(const std::string& type, const signals::Frame& frame) {
    std::string text =
        fmt::format("static void encode_{}(const double *value)\n{{\n    {} pdo;\n", type, type) +
        "    char put[65] = {0};\n    memset(&pdo, 0, sizeof pdo);\n";
    for (std::size_t i = 0; i < frame.signals.size(); ++i) {
        const Signal& signal = frame.signals[i];
        const auto line = [&](std::string_view call) {
            text += fmt::format(fmt::runtime(call), arg("t", type), arg("n", signal.name), arg("i", i),
                                arg("bit", signal.first_bit));
        };
        if (signal.scaled) {
            line("    put[{i}] = {t}_set_{n}(&pdo, value[{i}]) ? '1' : '0';\n");
        } else {
            line(!signal.values.empty() ? "    {t}_turn_{n}(&pdo, value[{i}] != 0);\n"
                 : signal.is_bit()      ? "    {t}_putbit(&pdo, {bit}u, value[{i}] != 0);\n"
                                        : "    {t}_setraw_{n}(&pdo, (int32_t)value[{i}]);\n");
            line("    put[{i}] = '1';\n");
        }
    }
    return text + fmt::format("    print_bytes(\"{}\", pdo.bytes, {}u);\n    printf(\"%s\\n\", put);\n}}\n",
                              frame.name, frame.length);
}

constexpr std::string_view reading =
    "int main(void)\n"
    "{\n"
    "    static char line[4096];\n"
    "    while (fgets(line, sizeof line, stdin) != NULL) {\n"
    "        char *word = strtok(line, \" \\n\");\n"
    "        char *rest = strtok(NULL, \" \\n\");\n"
    "        double value[64] = {0};\n"
    "        uint8_t data[8] = {0};\n"
    "        uint32_t cob_id = (uint32_t)strtoul(word, NULL, 16);\n"
    "        unsigned count = 0;\n"
    "        if (word[1] != 'P') {\n"
    "            for (; rest[2 * count] != 0; ++count) {\n"
    "                char byte[3] = {rest[2 * count], rest[2 * count + 1], 0};\n"
    "                data[count] = (uint8_t)strtoul(byte, NULL, 16);\n"
    "            }\n"
    "        } else {\n"
    "            for (; rest != NULL; rest = strtok(NULL, \" \\n\")) {\n"
    "                value[count++] = atof(rest);\n"
    "            }\n"
    "        }\n";

}  // namespace

std::string c_program(const partner::Half& half, const std::string& header) {
    std::string text = fmt::format(opening, arg("header", header));
    std::string calls;
    for (const signals::Frame& frame : half.frames) {
        const std::string type = partner::prefix(half) + "_" + lowered(frame.name);
        text += decoding(type, frame);
        calls +=
            fmt::format("        if (word[1] != 'P' && decode_{}(cob_id, data, count)) continue;\n", type);
        if (!frame.transmit()) {
            text += encoding(type, frame);
            calls += fmt::format("        if (strcmp(word, \"{}\") == 0) {{ encode_{}(value); continue; }}\n",
                                 frame.name, type);
        }
    }
    return text + std::string(reading) + calls + "        return 1;\n    }\n    return 0;\n}\n";
}

}  // namespace cgw::test
