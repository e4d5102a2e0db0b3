// Rows of a printed table that are none of cgw's business.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "input/table_rows.hpp"
#include "parameter/catalogue.hpp"

namespace cgw::input {

// A whole print of a device holds much that does not concern CANopen.
class ForeignRows {
  public:
    ForeignRows(parameter::Device device, const parameter::Catalogue& catalogue)
        : device_(device), catalogue_(catalogue) {}

    // Only what cannot be a slip: a number and a name that nobody here knows, and a name that is not nearly
    // one.
    bool contains(const TableRow& row, std::uint16_t number);

  private:
    bool is_parameter(const std::string& text) const;
    bool is_far(const std::string& name);
    void list_names();

    parameter::Device device_;
    const parameter::Catalogue& catalogue_;
    std::map<std::string, bool> is_far_;   // names looked at, without index
    std::vector<std::string_view> names_;  // of everything that can be set, without index
};

}  // namespace cgw::input
