#include "convert/formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "base/canopen_text.hpp"
#include "convert/concise_dcf.hpp"
#include "convert/writing.hpp"
#include "dictionary/data_types.hpp"
#include "dictionary/node.hpp"
#include "eds/writer.hpp"
#include "xdd/writer.hpp"

namespace cgw::convert {
namespace {

using dictionary::Dictionary;
using About = Format::About;

base::Bytes with_sections(std::string text, const std::vector<FurtherSection>& sections) {
    for (const FurtherSection& section : sections) {
        text.append("\r\n[").append(section.name).append("]\r\n");
        for (const std::string& line : section.lines) {
            text.append(line).append("\r\n");
        }
    }
    return base::to_bytes(text);
}

base::Bytes write_eds(const Description& description) {
    return with_sections(eds::write(description.dictionary), description.sections);
}
base::Bytes write_dcf(const Description& description) {
    return with_sections(eds::write(description.dictionary, *description.node), description.sections);
}
base::Bytes write_xdd(const Description& description) {
    return base::to_bytes(xdd::write(description.dictionary));
}
base::Bytes write_xdc(const Description& description) {
    return base::to_bytes(xdd::write(description.dictionary, *description.node));
}
base::Bytes write_concise_dcf(const Description& description) {
    return concise_dcf(downloads(description.dictionary, description.node->node_id));
}

constexpr std::array table{
    Format{"eds", "electronic data sheet (CiA 306)", ".eds", Medium::eds, About::device, write_eds},
    Format{"dcf", "device configuration file of one node (CiA 306)", ".dcf", Medium::dcf, About::node,
           write_dcf},
    Format{"xdd", "XML device description (CiA 311)", ".xdd", Medium::xdd, About::device, write_xdd},
    Format{"xdc", "XML configuration of one node (CiA 311)", ".xdc", Medium::xdc, About::node, write_xdc},
    Format{"concise-dcf", "what a manager writes into the node at boot (CiA 302, 1F22h)", ".cdcf",
           std::nullopt, About::node, write_concise_dcf},
    Format{"json", "all of it, for programs (schemas/device-description.schema.json)", ".json", std::nullopt,
           About::either, write_json},
    Format{"md", "table of the objects, in Markdown", ".md", Medium::markdown, About::either, write_markdown},
    Format{"csv", "table of the objects, for spreadsheets", ".csv", Medium::csv, About::either, write_csv},
};

std::size_t count_relative(const Dictionary& dictionary) {
    std::size_t count = 0;
    for (const dictionary::Object& object : dictionary.objects) {
        for (const dictionary::Variable& variable : object.variables) {
            count += variable.default_value.node_id_relative ? 1U : 0U;
        }
    }
    return count;
}

// What is to be read back holds its own name, and sections that say nothing of objects.
bool is_table(const Format& format) {
    return format.medium == Medium::markdown || format.medium == Medium::csv;
}
bool holds_sections(const Format& format) {
    return format.medium == Medium::eds || format.medium == Medium::dcf;
}

tl::unexpected<Refusal> refused(std::string why) {
    return tl::unexpected<Refusal>(Refusal{std::move(why)});
}

dictionary::Commissioning new_node(const Dictionary& dictionary, std::uint8_t node_id) {
    constexpr std::uint16_t identity = 0x1018;
    constexpr std::uint8_t serial_number = 4;
    dictionary::Commissioning node;
    node.node_id = node_id;
    node.node_name = dictionary.device.product_name;
    const dictionary::Variable* const serial = dictionary.find(identity, serial_number);
    node.serial_number = serial != nullptr ? static_cast<std::uint32_t>(serial->default_value.number) : 0;
    return node;
}

std::uint64_t highest_of(const dictionary::TypeRow& type) {
    if (type.kind == dictionary::TypeKind::boolean) {
        return 1;
    }
    const std::uint64_t highest = ~std::uint64_t{0} >> (64U - std::clamp(type.bits, 1U, 64U));
    return type.kind == dictionary::TypeKind::integer ? highest >> 1U : highest;
}

bool overflows(const dictionary::Variable& variable, std::uint8_t node_id) {
    const std::uint64_t highest = highest_of(dictionary::row_of(variable.type));
    const auto is_too_large = [&](const dictionary::Value& value) {
        return value.node_id_relative && (node_id > highest || value.number > highest - node_id);
    };
    const auto any = [&](const std::optional<dictionary::Value>& value) {
        return value && is_too_large(*value);
    };
    return is_too_large(variable.default_value) || any(variable.low_limit) || any(variable.high_limit) ||
           any(variable.parameter_value);
}

// The first formula that makes too large a number for its type.
std::optional<Refusal> overflow(const Dictionary& dictionary, std::uint8_t node_id) {
    for (const dictionary::Object& object : dictionary.objects) {
        for (const dictionary::Variable& variable : object.variables) {
            if (overflows(variable, node_id)) {
                return Refusal{
                    fmt::format("{}: a formula with $NODEID makes too large a number for {} in node {}",
                                base::object_text(object.index, variable.sub_index),
                                dictionary::row_of(variable.type).name, node_id),
                    object.index, variable.sub_index};
            }
        }
    }
    return std::nullopt;
}

// The description of a kind of device becomes that of one node of it.
tl::expected<void, Refusal> make_node(Description& description, const Request& request, Product& product) {
    if (!description.node) {
        if (!request.node_id) {
            return refused(
                fmt::format("--node-id is needed: {} is about one node, and the file does not say which",
                            request.format.name));
        }
        description.node = new_node(description.dictionary, *request.node_id);
        if (request.format.medium == Medium::dcf) {
            description.node->last_eds = description.dictionary.file.file_name;
        }
        if (auto refusal = overflow(description.dictionary, *request.node_id)) {
            return tl::unexpected<Refusal>(std::move(*refusal));
        }
        product.resolved = count_relative(description.dictionary);
        description.dictionary = dictionary::of_node(std::move(description.dictionary), *request.node_id);
    } else if (description.node->node_id == 0 && !request.node_id) {
        return refused("--node-id is needed: the file leaves the node number open");
    }
    if (request.node_id && description.node->node_id == 0) {
        description.node->node_id = *request.node_id;
    }
    product.node_id = description.node->node_id;
    if (auto refusal = overflow(description.dictionary, product.node_id)) {
        return tl::unexpected<Refusal>(std::move(*refusal));
    }
    return {};
}

}  // namespace

std::span<const Format> formats() {
    return table;
}

const Format* find_format(std::string_view name) {
    const auto* const found =
        std::find_if(table.begin(), table.end(), [name](const Format& each) { return each.name == name; });
    return found != table.end() ? found : nullptr;
}

const Format* format_of_file(std::string_view file_name) {
    const auto* const found = std::find_if(table.begin(), table.end(), [file_name](const Format& each) {
        return file_name.size() > each.ending.size() &&
               base::equal_ignoring_case(file_name.substr(file_name.size() - each.ending.size()),
                                         each.ending);
    });
    return found != table.end() ? found : nullptr;
}

tl::expected<Product, Refusal> convert(Description description, const Request& request) {
    Product product;
    const bool has_node = description.node && description.node->node_id != 0;
    if (has_node && request.node_id && *request.node_id != description.node->node_id) {
        return refused(
            fmt::format("the file is about node {}; leave --node-id out", description.node->node_id));
    }
    if (request.format.about != About::node && request.node_id) {
        return refused(fmt::format(
            "--node-id is for formats that are about one node, dcf, xdc and concise-dcf; {} keeps $NODEID as "
            "it stands",
            request.format.name));
    }
    if (request.format.about == About::node) {
        if (const auto made = make_node(description, request, product); !made) {
            return tl::unexpected(made.error());
        }
    }
    if (request.format.medium) {
        product.losses = lose(description, *request.format.medium);
        if (!request.file_name.empty() && !is_table(request.format)) {
            description.dictionary.file.file_name = request.file_name;
        }
    }
    if (!holds_sections(request.format)) {
        product.lost_sections = unread_of(description.sections);
    }
    product.bytes = request.format.write(description);
    product.no_entries = request.format.write == write_concise_dcf && is_without_entries(product.bytes);
    return product;
}

}  // namespace cgw::convert
