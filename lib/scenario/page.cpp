#include "scenario/actions.hpp"
namespace cgw::scenario {
std::string page() {
    return "";
}
}  // namespace cgw::scenario
