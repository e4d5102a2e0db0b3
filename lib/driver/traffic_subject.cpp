#include "driver/traffic_subject.hpp"

namespace cgw::driver {

traffic::Subject traffic_subject(const CheckedFile& file, const emit::Plant& plant) {
    const config::Configuration& configuration = file.configuration;
    traffic::Subject subject{.frames = signals::frames_of(file.settings, *file.catalogue, configuration),
                             .dictionary = &plant.dictionary,
                             .configuration_id = plant.configuration_id_text,
                             .node_id = configuration.node_id,
                             .partner = configuration.partner_node_id,
                             .heartbeat_period_us = configuration.heartbeat_producer.effective_us,
                             .heartbeat_monitoring_us = configuration.heartbeat_consumer.effective_us};
    for (const parameter::NetworkNode& node : file.settings.network_nodes) {
        subject.other_nodes.push_back(node.node_id);
    }
    return subject;
}

}  // namespace cgw::driver
