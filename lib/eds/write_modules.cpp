// The sections of the modules of a modular device.
#include <fmt/format.h>

#include <algorithm>

#include "eds/words.hpp"
#include "eds/writing.hpp"

namespace cgw::eds {
namespace {

using dictionary::Module;
using dictionary::ModuleExtension;

void information(Printer& out, const std::string& prefix, const Module& module) {
    out.section(prefix + "ModuleInfo");
    out.text_entry("ProductName", module.product_name);
    out.number_entry("ProductVersion", module.product_version);
    out.number_entry("ProductRevision", module.product_revision);
    out.text_entry("OrderCode", module.order_code);
}

void fixed_objects(Printer& out, const std::string& prefix, const std::vector<dictionary::Object>& objects) {
    std::vector<std::uint16_t> indices;
    indices.reserve(objects.size());
    for (const dictionary::Object& object : objects) {
        indices.push_back(object.index);
    }
    out.section(prefix + "FixedObjects");
    index_entries(out, "NrOfEntries", indices);
    for (const dictionary::Object& object : objects) {
        object_sections(out, object, FileKind::data_sheet, prefix + "Fixed");
    }
}

void extension(Printer& out, const std::string& prefix, const ModuleExtension& each) {
    out.section(fmt::format("{}SubExt{:04X}", prefix, each.index));
    out.text_entry("ParameterName", each.variable.name);
    out.entry("DataType", fmt::format("0x{:04X}", static_cast<unsigned>(each.variable.type)));
    out.entry("AccessType", access_types.at(static_cast<std::size_t>(each.variable.access)));
    variable_entries(out, each.variable, FileKind::data_sheet);
    const bool is_shared = each.count == 0 && each.shared_bits != 0;
    out.entry("Count", is_shared ? fmt::format("0;{}", each.shared_bits) : fmt::format("{}", each.count));
    out.flag_entry("ObjExtend", each.extends_objects);
}

void extensions(Printer& out, const std::string& prefix, const std::vector<ModuleExtension>& all) {
    std::vector<std::uint16_t> indices;
    indices.reserve(all.size());
    for (const ModuleExtension& each : all) {
        indices.push_back(each.index);
    }
    out.section(prefix + "SubExtends");
    index_entries(out, "NrOfEntries", indices);
    for (const ModuleExtension& each : all) {
        extension(out, prefix, each);
    }
}

void comments(Printer& out, const std::string& prefix, const std::vector<std::string>& lines) {
    out.section(prefix + "Comments");
    comment_entries(out, lines);
}

}  // namespace

void modules(Printer& out, const std::vector<Module>& all) {
    if (all.empty()) {
        return;
    }
    std::uint8_t highest = 0;
    for (const Module& module : all) {
        highest = std::max(highest, module.number);
    }
    out.section("SupportedModules");
    out.number_entry("NrOfEntries", highest);
    for (const Module& module : all) {
        const std::string prefix = fmt::format("M{}", module.number);
        information(out, prefix, module);
        comments(out, prefix, module.comments);
        fixed_objects(out, prefix, module.fixed_objects);
        extensions(out, prefix, module.extensions);
    }
}

}  // namespace cgw::eds
