#include "eds/writer.hpp"
#include "emit/artefacts.hpp"
#include "profile/gateway.hpp"
#include "xdd/writer.hpp"

namespace cgw::emit {

base::Bytes emit_eds(const Plant& plant, const Options& options) {
    dictionary::Dictionary dictionary = plant.dictionary;
    dictionary.file.file_name = options.eds_name;
    return base::to_bytes(eds::write(dictionary));
}

base::Bytes emit_xdd(const Plant& plant, const Options& options) {
    dictionary::Dictionary dictionary = plant.dictionary;
    dictionary.file.file_name = file_name(*find_format(*find_emitter("xdd"), ""), options);
    return base::to_bytes(xdd::write(dictionary));
}

base::Bytes emit_generic_eds(const Origin& origin, const Options& options) {
    profile::GatewayDocument document;
    document.file_name = options.eds_name;
    document.created = origin.date;
    document.tool_version = origin.tool_version_text;
    return base::to_bytes(eds::write(profile::generic_gateway_dictionary(document)));
}

}  // namespace cgw::emit
