#include "eds/writer.hpp"
#include "emit/artefacts.hpp"

namespace cgw::emit {

base::Bytes emit_eds(const Plant& plant, const Options& /*options*/) {
    return base::to_bytes(eds::write(plant.dictionary));
}

}  // namespace cgw::emit
