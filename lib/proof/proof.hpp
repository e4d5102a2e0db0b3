// Whether an artefact in a file still is what the parameter file makes: EDS, DCF, image and CAN database
// against the plant, object by object. In every difference A is the plant and B the artefact.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dbc/database.hpp"
#include "dictionary/difference.hpp"
#include "emit/emitter.hpp"
#include "image/image.hpp"

namespace cgw::proof {

struct Proof {
    std::string path;
    std::string_view kind;  // "EDS"
    std::string compared;   // "49 objects"
    dictionary::Differences differences;
    std::size_t strict_errors = 0;  // for which strict importers refuse the file; the findings tell them
};

// What a description says of a device, and of the one node where it does (DCF).
struct Description {
    const dictionary::Dictionary& dictionary;
    const dictionary::Commissioning* commissioning = nullptr;
};
Proof prove_description(const emit::Plant& plant, const Description& description);

// Everything that the gateway reads: objects, PDOs, buses, switches, sensors, signals; names and the model
// where the image has them. The version of cgw that wrote it does not count.
Proof prove_image(const emit::Plant& plant, const image::Image& image);

// Messages by identifier: name, sender, length, send type, cycle time; signals by name: place, sign, scaling,
// range, unit, named values, receivers. Comments and other people's messages do not count, one that names the
// gateway as sender does.
Proof prove_database(const emit::Plant& plant, const dbc::Database& database);

// What was compared with what.
struct Subject {
    std::string path;              // of the parameter file
    std::string configuration_id;  // 16 digits
    unsigned node_id = 0;
};

bool all_same(std::span<const Proof> proofs);

struct Format {
    std::string_view name;  // "human"
    std::string_view summary;
    std::string (*render)(const Subject& subject, std::span<const Proof> proofs);
};
std::span<const Format> formats();  // the first for people; json: schemas/proof-report.schema.json

}  // namespace cgw::proof
