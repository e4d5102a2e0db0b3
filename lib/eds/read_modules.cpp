// Modular devices: the kinds of modules, and what each adds to the dictionary.
#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "eds/reading.hpp"

namespace cgw::eds {
namespace {

using dictionary::Module;
using dictionary::ModuleExtension;

enum class ModuleKey : std::uint8_t { product_name, product_version, product_revision, order_code };

constexpr std::array module_keys{
    KeyRow{"ProductName", static_cast<std::uint8_t>(ModuleKey::product_name)},
    KeyRow{"ProductVersion", static_cast<std::uint8_t>(ModuleKey::product_version)},
    KeyRow{"ProductRevision", static_cast<std::uint8_t>(ModuleKey::product_revision)},
    KeyRow{"OrderCode", static_cast<std::uint8_t>(ModuleKey::order_code)},
};

enum class ExtensionKey : std::uint8_t { count, extends_objects };

constexpr std::array extension_keys{
    KeyRow{"Count", static_cast<std::uint8_t>(ExtensionKey::count)},
    KeyRow{"ObjExtend", static_cast<std::uint8_t>(ExtensionKey::extends_objects)},
};

void read_information(Reading& reading, const Section& section, Module& module) {
    const KeyLines lines = reading.key_lines(section, module_keys);
    module.product_name = reading.text(lines[ModuleKey::product_name]);
    reading.assign(lines[ModuleKey::product_version], highest_u32, module.product_version);
    reading.assign(lines[ModuleKey::product_revision], highest_u32, module.product_revision);
    module.order_code = reading.text(lines[ModuleKey::order_code]);
}

// `Count=2` or, of several modules in one sub-object, `Count=0;4`.
void read_count(Reading& reading, std::uint32_t line, ModuleExtension& extension) {
    if (line == 0) {
        return;
    }
    const std::string_view text = reading.document.value(line);
    const std::size_t semicolon = text.find(';');
    const Number bits = semicolon != std::string_view::npos
                            ? parse_number(base::trimmed(text.substr(semicolon + 1)))
                            : Number{};
    if (base::trimmed(text.substr(0, semicolon)) == "0" && bits.reading == Number::Reading::number &&
        bits.magnitude <= highest_u8 && !bits.negative && !bits.node_id_relative) {
        extension.shared_bits = static_cast<std::uint32_t>(bits.magnitude);
    } else {
        reading.assign(line, highest_u8, extension.count);
    }
}

void read_extension(Reading& reading, std::uint32_t number, Module& module) {
    auto variable = read_variable(reading, number);
    if (!variable) {
        return;
    }
    ModuleExtension& extension = module.extensions.emplace_back();
    extension.index = reading.sections.name(number).index;
    extension.variable = std::move(*variable);
    const KeyLines lines = reading.key_lines(reading.section(number), extension_keys);
    read_count(reading, lines[ExtensionKey::count], extension);
    reading.assign_flag(lines[ExtensionKey::extends_objects], extension.extends_objects);
}

}  // namespace

void read_modules(Reading& reading, std::vector<Module>& modules) {
    std::uint32_t last = 0;
    bool is_first = true;
    for (const std::uint32_t number : reading.sections.ordered()) {
        const SectionName& name = reading.sections.name(number);
        if (name.module == 0 || name.kind == SectionKind::unknown) {
            continue;
        }
        if (modules.empty() || modules.back().number != name.module) {
            modules.emplace_back().number = name.module;
            modules.back().fixed_objects = read_objects(reading, name.module);
            is_first = true;
        }
        const bool is_repeated = !is_first && reading.document.same_name(last, number);
        last = number;
        is_first = false;
        if (is_repeated) {
            continue;
        }
        if (name.kind == SectionKind::module_info) {
            read_information(reading, reading.section(number), modules.back());
        } else if (name.kind == SectionKind::module_comments) {
            read_comments(reading, number, modules.back().comments);
        } else if (name.kind == SectionKind::module_sub_extension) {
            read_extension(reading, number, modules.back());
        }
    }
}

}  // namespace cgw::eds
