// Artefacts in files against a plant.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "diagnostic/renderers.hpp"
#include "driver/plant.hpp"
#include "proof/proof.hpp"

namespace cgw::driver {

// Paths; "-" is standard input.
struct Artefacts {
    std::vector<std::string> descriptions;  // EDS, DCF, XDD, XDC
    std::vector<std::string> images;
    std::vector<std::string> databases;
};

struct Proofs {
    std::vector<proof::Proof> all;                // of the artefacts that could be read, in the order above
    std::vector<diagnostic::FileReport> reports;  // of those with findings
    std::map<std::string, std::string> sources;
    bool unreadable = false;  // one could not be read at all: exit code 3
    // One has errors, if only for strict importers. Those with other errors are not among `all`.
    bool has_errors = false;
};

// Data sheets are checked as `cgw eds check --strict` does as well. An image may be a region read out of a
// device.
Proofs prove(const emit::Plant& plant, const Artefacts& artefacts);

}  // namespace cgw::driver
