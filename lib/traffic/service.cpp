#include "traffic/service.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/canopen_text.hpp"
#include "facts/identifiers.hpp"

namespace cgw::traffic {
namespace {

namespace cob = facts::cob;

constexpr std::array<std::uint32_t, 2> lss_identifiers{0x7E4, 0x7E5};

constexpr std::string_view service_texts[] = {"nmt",       "sync",      "time",        "emergency",
                                              "pdo",       "other-pdo", "sdo-request", "sdo-answer",
                                              "heartbeat", "lss",       "unknown"};
constexpr std::string_view service_names[] = {"NMT", "SYNC", "TIME", "EMCY", "PDO", "PDO",
                                              "SDO", "SDO",  "HB",   "LSS",  "?"};

Service service_of_base(std::uint32_t base) {
    switch (base) {
        case cob::emergency:
            return Service::emergency;
        case cob::sdo_answer:
            return Service::sdo_answer;
        case cob::sdo_request:
            return Service::sdo_request;
        case cob::heartbeat:
            return Service::heartbeat;
        default:
            break;
    }
    const auto is_base = [base](std::uint16_t other) { return other == base; };
    const bool pdo = std::any_of(cob::tpdo.begin(), cob::tpdo.end(), is_base) ||
                     std::any_of(cob::rpdo.begin(), cob::rpdo.end(), is_base);
    return pdo ? Service::other_pdo : Service::unknown;
}

// By the predefined connection set alone.
Owner default_owner(std::uint32_t identifier) {
    if (identifier == cob::nmt) {
        return {.service = Service::nmt};
    }
    if (identifier == cob::sync) {
        return {.service = Service::sync};
    }
    if (identifier == cob::time) {
        return {.service = Service::time};
    }
    if (std::find(lss_identifiers.begin(), lss_identifiers.end(), identifier) != lss_identifiers.end()) {
        return {.service = Service::lss};
    }
    const auto node = static_cast<std::uint8_t>(identifier & cob::node_mask);
    const Service service = service_of_base(identifier & cob::function_mask);
    return service == Service::unknown || node == 0 ? Owner{} : Owner{.service = service, .node = node};
}

bool is_expected(const Subject& subject, const Owner& owner) {
    switch (owner.service) {
        case Service::nmt:
        case Service::sync:
        case Service::time:
        case Service::lss:
        case Service::pdo:
            return true;
        case Service::unknown:
            return false;
        default:
            break;
    }
    if (owner.node == subject.node_id) {  // it has neither EMCY nor PDOs beside the active ones (D42)
        return owner.service != Service::emergency && owner.service != Service::other_pdo;
    }
    const auto& others = subject.other_nodes;
    return owner.node == subject.partner ||
           std::find(others.begin(), others.end(), owner.node) != others.end();
}

}  // namespace

std::string_view to_text(Service service) {
    return service_texts[static_cast<std::size_t>(service)];
}

Owners::Owners(const Subject& subject) {
    for (std::uint32_t identifier = 0; identifier < owners_.size(); ++identifier) {
        owners_[identifier] = default_owner(identifier);
    }
    for (const signals::Frame& frame : subject.frames) {
        owners_[frame.identifier % owners_.size()] = {
            .service = Service::pdo, .node = subject.node_id, .frame = &frame};
    }
    for (Owner& owner : owners_) {
        owner.expected = is_expected(subject, owner);
    }
}

std::string name_of(const Owner& owner) {
    return owner.frame != nullptr ? owner.frame->name
                                  : std::string(service_names[static_cast<std::size_t>(owner.service)]);
}

std::string default_use(std::uint32_t identifier) {
    const Owner owner = default_owner(identifier);
    if (owner.service == Service::unknown) {
        return {};
    }
    if (owner.service != Service::other_pdo) {
        return owner.node == 0 ? name_of(owner) : fmt::format("{} of node {}", name_of(owner), owner.node);
    }
    const std::uint32_t base = identifier & cob::function_mask;
    const auto transmit = std::find(cob::tpdo.begin(), cob::tpdo.end(), base);
    const bool is_transmit = transmit != cob::tpdo.end();
    const auto number = is_transmit ? transmit - cob::tpdo.begin()
                                    : std::find(cob::rpdo.begin(), cob::rpdo.end(), base) - cob::rpdo.begin();
    return fmt::format("{} of node {}", base::pdo_name(is_transmit, static_cast<unsigned>(number + 1)),
                       owner.node);
}

}  // namespace cgw::traffic
