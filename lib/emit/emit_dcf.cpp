#include "convert/concise_dcf.hpp"
#include "eds/writer.hpp"
#include "emit/artefacts.hpp"
#include "emit/node_file.hpp"
#include "xdd/writer.hpp"

namespace cgw::emit {
namespace {

NodeFile node_file_of(std::string_view emitter, const Plant& plant, const Options& options) {
    return node_file(plant, options, file_name(*find_format(*find_emitter(emitter), ""), options));
}

}  // namespace

base::Bytes emit_dcf(const Plant& plant, const Options& options) {
    const NodeFile file = node_file_of("dcf", plant, options);
    return base::to_bytes(eds::write(file.dictionary, file.node));
}

base::Bytes emit_xdc(const Plant& plant, const Options& options) {
    const NodeFile file = node_file_of("xdc", plant, options);
    return base::to_bytes(xdd::write(file.dictionary, file.node));
}

base::Bytes emit_concise_dcf(const Plant& plant, const Options& options) {
    const NodeFile file = node_file_of("concise-dcf", plant, options);
    return convert::concise_dcf(convert::downloads(file.dictionary, file.node.node_id));
}

}  // namespace cgw::emit
