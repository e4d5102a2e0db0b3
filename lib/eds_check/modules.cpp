// Modules of a modular device, and links between objects: what they name against what stands in the file.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "diagnostic/rules/eds_check.hpp"
#include "eds_check/context.hpp"
#include "eds_check/counts.hpp"
#include "eds_check/subjects.hpp"

namespace cgw::eds_check {
namespace {

namespace rules = diagnostic::rules;
using eds::SectionKind;
using eds::SectionName;

// A list of a module, and the sections of what it lists.
struct ListRow {
    SectionKind list;
    SectionKind listed;
    std::string_view name;    // behind M1
    std::string_view prefix;  // of what it lists, behind M1
};
constexpr std::array list_rows{
    ListRow{SectionKind::module_fixed_objects, SectionKind::object, "FixedObjects", "Fixed"},
    ListRow{SectionKind::module_sub_extends, SectionKind::module_sub_extension, "SubExtends", "SubExt"}};

// The first section of each module.
std::map<std::uint8_t, std::uint32_t> modules_of(const Context& context) {
    std::map<std::uint8_t, std::uint32_t> modules;
    for (const std::uint32_t number : context.sheet.sections.ordered()) {
        const SectionName& name = context.sheet.sections.name(number);
        if (name.module != 0 && name.kind != SectionKind::unknown) {
            modules.try_emplace(name.module, number);
        }
    }
    return modules;
}

void check_count(const Context& context, const std::map<std::uint8_t, std::uint32_t>& modules) {
    const auto section = context.sheet.sections.find(SectionKind::supported_modules);
    if (!section && !modules.empty()) {
        context.reading.report(
            rules::eds_module, context.header_of(modules.begin()->second),
            fmt::format("{} is of a module, and [SupportedModules] is missing",
                        context.reading.quoted(context.reading.section(modules.begin()->second))));
        return;
    }
    const std::uint32_t line = context.line_of(SectionKind::supported_modules, "NrOfEntries");
    const auto stated = context.number(line);
    if (!stated) {
        return;
    }
    for (std::uint64_t number = 1; number <= std::min<std::uint64_t>(*stated, eds::highest_u8); ++number) {
        if (!modules.contains(static_cast<std::uint8_t>(number))) {
            context.reading.report(
                rules::eds_module, context.document.value_span(line),
                fmt::format("NrOfEntries is {}, and no section describes module {}", *stated, number));
            break;
        }
    }
    if (const auto beyond =
            modules.upper_bound(static_cast<std::uint8_t>(std::min<std::uint64_t>(*stated, eds::highest_u8)));
        beyond != modules.end()) {
        context.reading.report(rules::eds_module, context.header_of(beyond->second),
                               fmt::format("module {} stands in the file, and [SupportedModules] counts {}",
                                           beyond->first, *stated),
                               "", {{context.reading.location(context.document.value_span(line)), "here"}});
    }
}

// Calls `take(index, line)` for each entry of a list of indices.
template <typename Take>
void for_each_index(const Context& context, std::uint32_t section, Take take) {
    const eds::Section& of = context.reading.section(section);
    for (std::uint32_t line = of.header + 1; line < of.end; ++line) {
        const auto index = is_list_entry(context, line) ? context.number(line) : std::nullopt;
        if (index && *index <= eds::highest_u16) {
            take(static_cast<std::uint16_t>(*index), line);
        }
    }
}

using Lines = std::map<std::uint16_t, std::uint32_t>;

void check_listed(const Context& context, std::uint8_t module, const ListRow& row, Lines& listed) {
    const auto list = context.sheet.sections.find({.kind = row.list, .module = module});
    if (!list) {
        return;
    }
    for_each_index(context, *list, [&](std::uint16_t index, std::uint32_t line) {
        const auto [first, is_new] = listed.try_emplace(index, line);
        if (!is_new) {
            context.reading.report(
                rules::eds_module, context.document.value_span(line),
                fmt::format("{} is listed already", object_text(index)), "",
                {{context.reading.location(context.document.value_span(first->second)), "here"}});
        } else if (!context.sheet.sections.find({.kind = row.listed, .module = module, .index = index})) {
            context.reading.report(rules::eds_module, context.document.value_span(line),
                                   fmt::format("{} is listed, and [M{}{}{:04X}] is missing",
                                               object_text(index), module, row.prefix, index));
        }
    });
}

void check_lists(const Context& context, std::uint8_t module) {
    std::array<Lines, list_rows.size()> listed;
    for (std::size_t i = 0; i < list_rows.size(); ++i) {
        check_listed(context, module, list_rows[i], listed[i]);
    }
    for (const Group& group : context.model.groups_of(module)) {
        const std::size_t i = group.is_extension ? 1 : 0;
        if (group.has_section && !listed[i].contains(group.index)) {
            context.reading.report(rules::eds_module, context.header_of(group.own().section),
                                   fmt::format("{} is not listed in [M{}{}]", context.label(group.own()),
                                               module, list_rows[i].name));
        }
    }
}

void check_connected(const Context& context, const std::map<std::uint8_t, std::uint32_t>& modules) {
    const auto section = context.sheet.sections.find(SectionKind::connected_modules);
    if (!section) {
        return;
    }
    for_each_index(context, *section, [&](std::uint16_t number, std::uint32_t line) {
        if (number > eds::highest_u8 || !modules.contains(static_cast<std::uint8_t>(number))) {
            context.reading.report(
                rules::eds_module, context.document.value_span(line),
                fmt::format("module {} is connected, and no section describes it", number));
        }
    });
}

}  // namespace

void check_modules(const Context& context) {
    const auto modules = modules_of(context);
    check_count(context, modules);
    for (const auto& [module, first] : modules) {
        if (!context.sheet.sections.find({.kind = SectionKind::module_info, .module = module})) {
            context.reading.report(
                rules::eds_module, context.header_of(first),
                fmt::format("module {0} has sections, and [M{0}ModuleInfo] is missing", module));
        }
        check_lists(context, module);
    }
    check_connected(context, modules);
}

void check_object_links(const Context& context) {
    const std::span<const eds::Section> sections = context.document.sections();
    for (std::uint32_t number = 0; number < sections.size(); ++number) {
        const SectionName& name = context.sheet.sections.name(number);
        if (name.kind != SectionKind::object_links) {
            continue;
        }
        for_each_index(context, number, [&](std::uint16_t index, std::uint32_t line) {
            const SectionName in_module{.kind = SectionKind::object, .module = name.module, .index = index};
            if (context.model.find(index) == nullptr && context.sheet.dictionary.find(index) == nullptr &&
                context.model.find(in_module) == nullptr) {
                context.reading.report(
                    rules::eds_object_link, context.document.value_span(line),
                    fmt::format("{} links {}, which does not exist", context.reading.quoted(sections[number]),
                                object_text(index)));
            }
        });
    }
}

}  // namespace cgw::eds_check
