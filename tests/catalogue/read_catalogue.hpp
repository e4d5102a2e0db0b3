// Reads catalogue texts on top of the shipped rows.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "catalogue/catalogue.hpp"
#include "catalogue/findings_text.hpp"
#include "parameter/catalogue.hpp"

namespace cgw::test {

inline const std::string governor = "device = \"governor\"\n";  // rows start in line 2

class ReadCatalogue : public testing::Test {
  protected:
    bool read(const std::string& text) {
        findings = {};
        return cgw::catalogue::read_catalogue(text, "more.toml", catalogue, findings);
    }
    // Findings of a governor's file with this one row.
    std::string row(const std::string& cells) {
        read(governor + "[[row]]\n" + cells + "\n");
        return cgw::test::findings_text(findings);
    }
    std::string file(const std::string& text) {
        read(text);
        return cgw::test::findings_text(findings);
    }
    const parameter::Row* find(int number) const {
        return catalogue.find(parameter::Device::governor, static_cast<std::uint16_t>(number));
    }

    parameter::Catalogue catalogue{cgw::catalogue::shipped_rows()};
    cgw::diagnostic::Findings findings;
};

inline const std::string torque = "number = 2990\nname = \"TorqueActual\"\nkind = \"measurement\"\n";

}  // namespace cgw::test
