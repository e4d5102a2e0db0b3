// The partner's half of a plant, in its forms.
#include "emit/artefacts.hpp"
#include "emit/partner_half.hpp"

namespace cgw::emit {
partner::Half partner_half(const Plant& plant) {
    const config::Configuration& configuration = plant.configuration;
    return {.title = plant.settings.title,
            .configuration_id = plant.configuration_id_text,
            .tool_version = plant.tool_version_text,
            .node_id = configuration.node_id,
            .partner_node_id = configuration.partner_node_id,
            .bit_rate = config::bit_rate(configuration.can2, plant.settings.can2_bit_timing),
            .heartbeat_us = configuration.heartbeat_producer.effective_us,
            .partner_heartbeat_us = configuration.heartbeat_consumer.effective_us,
            .frames = signals::frames_of(plant.settings, plant.catalogue, configuration)};
}

base::Bytes emit_c_header(const Plant& plant, const Options& /*options*/) {
    return base::to_bytes(partner::c_header(partner_half(plant)));
}

base::Bytes emit_points(const Plant& plant, const Options& /*options*/) {
    return base::to_bytes(partner::points(partner_half(plant)));
}

base::Bytes emit_python_canopen(const Plant& plant, const Options& /*options*/) {
    return base::to_bytes(partner::python_canopen(partner_half(plant)));
}

base::Bytes emit_structured_text(const Plant& plant, const Options& /*options*/) {
    return base::to_bytes(partner::structured_text(partner_half(plant)));
}

base::Bytes emit_stx(const Plant& plant, const Options& /*options*/) {
    return base::to_bytes(partner::stx(partner_half(plant)));
}

}  // namespace cgw::emit
