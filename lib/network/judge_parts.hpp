// What the parts of the judgement share; not for other rooms.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "base/canopen_text.hpp"
#include "diagnostic/diagnostic.hpp"
#include "network/judge.hpp"
#include "network/message.hpp"

namespace cgw::network {

// "481h TPDO4 of node 1"
inline std::string label_of(const Message& message) {
    return fmt::format("{} {}", base::identifier_text(message.identifier), message.label());
}

// Reports the first findings of a kind, and how many more there are.
class Listed {
  public:
    Listed(diagnostic::Findings& findings, const diagnostic::Rule& rule) : findings_(findings), rule_(rule) {}
    Listed(const Listed&) = delete;
    Listed& operator=(const Listed&) = delete;
    ~Listed() {
        if (count_ > most_findings) {
            last_.message = fmt::format("{}, and {} more like this", last_.message, count_ - most_findings);
        }
        if (count_ != 0) {
            findings_.report(std::move(last_));
        }
    }

    void report(const diagnostic::Location& where, std::string message, std::string help = {}) {
        if (++count_ <= most_findings) {
            if (count_ > 1) {
                findings_.report(std::move(last_));
            }
            last_ = {.rule = &rule_, .message = std::move(message), .where = where, .help = std::move(help)};
        }
    }
    void relate(const diagnostic::Location& where, std::string message) {
        if (count_ <= most_findings) {
            last_.related.push_back({where, std::move(message)});
        }
    }

  private:
    diagnostic::Findings& findings_;
    const diagnostic::Rule& rule_;
    diagnostic::Diagnostic last_;
    std::size_t count_ = 0;
};

}  // namespace cgw::network
