// A valid parameter file with everything the emitters need.
#pragma once

#include <string>

#include "base/result.hpp"
#include "dictionary/dictionary.hpp"
#include "driver/check_file.hpp"
#include "emit/emitter.hpp"

namespace cgw::driver {

// The one version, from project(VERSION).
std::string tool_version();

// For artefacts that need no parameter file. Fails on a malformed SOURCE_DATE_EPOCH.
base::Result<emit::Origin> origin();

// As base::short_id() shows it.
std::string short_configuration_id(const parameter::Settings& settings);

// Refers to the checked file, which must outlive it and be valid().
class Plant {
  public:
    static base::Result<Plant> make(const CheckedFile& file);

    emit::Plant view() const;

  private:
    explicit Plant(const CheckedFile& file) : file_(&file) {}

    const CheckedFile* file_;
    dictionary::Dictionary dictionary_;
    std::array<std::uint8_t, 32> configuration_id_{};
};

}  // namespace cgw::driver
