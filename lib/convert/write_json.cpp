// All of a description for programs: schemas/device-description.schema.json. Values are texts, as an EDS
// writes them: JSON has no numbers of 64 bits and no $NODEID.
#include "base/json.hpp"
#include "base/utf8.hpp"
#include "convert/writing.hpp"
#include "dictionary/data_types.hpp"
#include "dictionary/value_text.hpp"
#include "eds/value_text.hpp"

namespace cgw::convert {
namespace {

using base::JsonWriter;
using dictionary::Object;
using dictionary::Value;
using dictionary::Variable;

void text(JsonWriter& out, std::string_view key, std::string_view value) {
    out.key(key).string(base::to_utf8(value));
}
void number(JsonWriter& out, std::string_view key, std::uint32_t value) {
    out.key(key).integer(value);
}
void flag(JsonWriter& out, std::string_view key, bool value) {
    out.key(key).boolean(value);
}

template <typename Numbers>
void numbers(JsonWriter& out, std::string_view key, const Numbers& values) {
    out.key(key).begin_array();
    for (const auto value : values) {
        out.integer(value);
    }
    out.end_array();
}

void texts(JsonWriter& out, std::string_view key, const std::vector<std::string>& values) {
    out.key(key).begin_array();
    for (const std::string& value : values) {
        out.string(base::to_utf8(value));
    }
    out.end_array();
}

void value(JsonWriter& out, std::string_view key, const Value* of, object::DataType type) {
    out.key(key);
    if (of == nullptr) {
        out.null();
    } else {
        out.string(base::to_utf8(eds::value_text(*of, dictionary::row_of(type))));
    }
}

const Value* pointer(const std::optional<Value>& of) {
    return of ? &*of : nullptr;
}

void variable_members(JsonWriter& out, const Variable& variable) {
    out.key("sub_index").integer(variable.sub_index);
    text(out, "name", variable.name);
    out.key("type").string(dictionary::row_of(variable.type).name);
    out.key("access").string(dictionary::access_text(variable.access));
    flag(out, "pdo_mapping", variable.pdo_mapping);
    number(out, "flags", variable.flags);
    value(out, "default", variable.no_default ? nullptr : &variable.default_value, variable.type);
    value(out, "low_limit", pointer(variable.low_limit), variable.type);
    value(out, "high_limit", pointer(variable.high_limit), variable.type);
    value(out, "value", pointer(variable.parameter_value), variable.type);
    text(out, "denotation", variable.denotation);
    text(out, "upload_file", variable.upload_file);
    text(out, "download_file", variable.download_file);
}

void objects(JsonWriter& out, std::string_view key, const std::vector<Object>& all) {
    out.key(key).begin_array();
    for (const Object& object : all) {
        out.begin_object();
        number(out, "index", object.index);
        text(out, "name", object.name);
        out.key("object_type").string(dictionary::object_code_text(object.code));
        number(out, "flags", object.flags);
        text(out, "denotation", object.denotation);
        numbers(out, "links", object.object_links);
        out.key("variables").begin_array();
        for (const Variable& variable : object.variables) {
            out.begin_object();
            variable_members(out, variable);
            out.end_object();
        }
        out.end_array().end_object();
    }
    out.end_array();
}

void file_member(JsonWriter& out, const dictionary::FileInformation& file) {
    out.key("file").begin_object();
    text(out, "name", file.file_name);
    number(out, "version", file.file_version);
    number(out, "revision", file.file_revision);
    text(out, "eds_version", file.eds_version);
    text(out, "description", file.description);
    text(out, "creation_date", file.creation_date);
    text(out, "creation_time", file.creation_time);
    text(out, "created_by", file.created_by);
    text(out, "modification_date", file.modification_date);
    text(out, "modification_time", file.modification_time);
    text(out, "modified_by", file.modified_by);
    out.end_object();
}

void device_member(JsonWriter& out, const dictionary::DeviceInformation& device) {
    out.key("device").begin_object();
    text(out, "vendor_name", device.vendor_name);
    number(out, "vendor_number", device.vendor_number);
    text(out, "product_name", device.product_name);
    number(out, "product_number", device.product_number);
    number(out, "revision_number", device.revision_number);
    text(out, "order_code", device.order_code);
    numbers(out, "bit_rates_kbit", device.bit_rates_kbit);
    flag(out, "simple_boot_up_master", device.simple_boot_up_master);
    flag(out, "simple_boot_up_slave", device.simple_boot_up_slave);
    number(out, "granularity", device.granularity);
    flag(out, "dynamic_channels", device.dynamic_channels);
    flag(out, "group_messaging", device.group_messaging);
    number(out, "receive_pdos", device.receive_pdos);
    number(out, "transmit_pdos", device.transmit_pdos);
    flag(out, "lss_supported", device.lss_supported);
    number(out, "compact_pdo", device.compact_pdo);
    out.end_object();
}

void node_member(JsonWriter& out, const std::optional<dictionary::Commissioning>& node) {
    out.key("node");
    if (!node) {
        out.null();
        return;
    }
    out.begin_object();
    text(out, "last_eds", node->last_eds);
    number(out, "node_id", node->node_id);
    text(out, "node_name", node->node_name);
    out.key("bit_rate_kbit");
    if (node->bit_rate_kbit) {
        out.integer(*node->bit_rate_kbit);
    } else {
        out.null();
    }
    number(out, "net_number", node->net_number);
    text(out, "network_name", node->network_name);
    flag(out, "canopen_manager", node->canopen_manager);
    number(out, "serial_number", node->serial_number);
    numbers(out, "connected_modules", node->connected_modules);
    out.end_object();
}

void modules_member(JsonWriter& out, const std::vector<dictionary::Module>& modules) {
    out.key("modules").begin_array();
    for (const dictionary::Module& module : modules) {
        out.begin_object();
        number(out, "number", module.number);
        text(out, "product_name", module.product_name);
        number(out, "product_version", module.product_version);
        number(out, "product_revision", module.product_revision);
        text(out, "order_code", module.order_code);
        texts(out, "comments", module.comments);
        objects(out, "fixed_objects", module.fixed_objects);
        out.key("extensions").begin_array();
        for (const dictionary::ModuleExtension& extension : module.extensions) {
            out.begin_object();
            number(out, "index", extension.index);
            number(out, "count", extension.count);
            number(out, "shared_bits", extension.shared_bits);
            flag(out, "extends_objects", extension.extends_objects);
            out.key("variable").begin_object();
            variable_members(out, extension.variable);
            out.end_object().end_object();
        }
        out.end_array().end_object();
    }
    out.end_array();
}

}  // namespace

base::Bytes write_json(const Description& description) {
    JsonWriter out;
    out.begin_object();
    number(out, "format_version", 1);
    file_member(out, description.dictionary.file);
    device_member(out, description.dictionary.device);
    node_member(out, description.node);
    texts(out, "comments", description.dictionary.comments);
    numbers(out, "dummies", description.dictionary.supported_dummies);
    objects(out, "objects", description.dictionary.objects);
    modules_member(out, description.dictionary.modules);
    out.end_object();
    return base::to_bytes(base::pretty_json(out.take()));
}

}  // namespace cgw::convert
