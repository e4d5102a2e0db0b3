#include "dictionary/node.hpp"

namespace cgw::dictionary {
namespace {

void resolve(Value& value, std::uint8_t node_id) {
    value.number = value.resolve(node_id);
    value.node_id_relative = false;
}

void resolve(std::optional<Value>& value, std::uint8_t node_id) {
    if (value) {
        resolve(*value, node_id);
    }
}

}  // namespace

Dictionary of_node(Dictionary sheet, std::uint8_t node_id) {
    for (Object& object : sheet.objects) {
        for (Variable& variable : object.variables) {
            resolve(variable.default_value, node_id);
            resolve(variable.low_limit, node_id);
            resolve(variable.high_limit, node_id);
            resolve(variable.parameter_value, node_id);
            const bool changes = variable.run_time || variable.pdo_mapping;
            if (!variable.parameter_value && !variable.no_default && !changes) {
                variable.parameter_value = variable.default_value;
            }
        }
    }
    return sheet;
}

Dictionary without_node(Dictionary configuration) {
    for (Object& object : configuration.objects) {
        object.denotation.clear();
        for (Variable& variable : object.variables) {
            variable.parameter_value.reset();
            variable.denotation.clear();
            variable.upload_file.clear();
            variable.download_file.clear();
        }
    }
    return configuration;
}

}  // namespace cgw::dictionary
