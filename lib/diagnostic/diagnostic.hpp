// A finding as plain data, and the list they are collected in.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "diagnostic/location.hpp"
#include "diagnostic/rule.hpp"

namespace cgw::diagnostic {

struct Related {
    Location where;
    std::string message;
};

// Text style: lower case, no final period; says what was found, quotes the parameter as
// `16404 CanOpTPDO5-16ID(0)`; `help` only for a concrete fix.
struct Diagnostic {
    const Rule* rule = nullptr;
    std::string message;
    Location where;
    std::vector<Related> related{};
    std::string help{};
    bool promoted = false;  // a finding that the user wants treated as an error (--werror, --strict)

    Level level() const { return promoted ? Level::error : rule->level; }
};

class Findings {
  public:
    void report(Diagnostic finding) { all_.push_back(std::move(finding)); }

    const std::vector<Diagnostic>& all() const { return all_; }
    bool has_errors() const;
    std::size_t count(Level level) const;

    // By path, then position, then code; equal findings stay in the order of reporting.
    void sort();

    // Hides the warnings and notes of these rules; errors stay. Promotes the remaining warnings.
    void hide(const std::vector<const Rule*>& rules);
    void promote_warnings();

    // Makes errors of the findings of these rules.
    void promote(const std::vector<const Rule*>& rules);

  private:
    std::vector<Diagnostic> all_;
};

}  // namespace cgw::diagnostic
