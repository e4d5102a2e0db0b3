// A plant around a hand-written configuration, and an emitter's output as text.
#pragma once

#include <string>

#include "emit/emitter.hpp"
#include "profile/gateway.hpp"
#include "support/sample_configuration.hpp"

namespace cgw::test {

struct SamplePlant {
    explicit SamplePlant(config::Configuration from, const std::string& title = "Genset 2, starboard")
        : configuration(std::move(from)) {
        settings.title = title;
        profile::GatewayDocument document;
        document.title = title;
        document.configuration_id = "0123456789abcdef";
        document.tool_version = "0.1.0";
        dictionary = profile::gateway_dictionary(configuration, document);
    }

    emit::Plant view() const {
        return {settings, catalogue, configuration, dictionary, {}, "0123456789abcdef", {0, 1, 0}, "0.1.0"};
    }

    std::string emit(const std::string& name, const std::string& format) const {
        emit::Options options;
        options.format = format;
        const base::Bytes bytes = emit::find_emitter(name)->emit(view(), options);
        return {bytes.begin(), bytes.end()};
    }

    parameter::Settings settings;
    parameter::Catalogue catalogue{{}};
    config::Configuration configuration;
    dictionary::Dictionary dictionary;
};

}  // namespace cgw::test
