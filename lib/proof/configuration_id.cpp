#include "proof/configuration_id.hpp"

#include "base/ascii.hpp"
#include "base/sha256.hpp"

namespace cgw::proof {
namespace {

constexpr std::string_view id_before = ", configuration ";
constexpr std::size_t id_digits = 16;

}  // namespace

Identified split_id(std::string_view text) {
    const std::size_t at = text.rfind(id_before);
    const std::string_view id = at != std::string_view::npos ? text.substr(at + id_before.size()) : "";
    const bool is_id = id.size() == id_digits && base::consists_of(id, base::hexadecimal_digits);
    return is_id ? Identified{text.substr(0, at), id} : Identified{text, ""};
}

std::string configuration_id(const dictionary::Dictionary& description) {
    return std::string(split_id(description.file.description).id);
}

std::string configuration_id(const dbc::Database& database) {
    return std::string(split_id(database.version).id);
}

std::string configuration_id(const image::Image& image) {
    return base::to_hex(image.configuration_id());
}

}  // namespace cgw::proof
