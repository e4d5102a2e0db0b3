// docs/image-format.md: refusal codes, sizes and versions. Its tables of fields are held to the code by
// tests/inspect/page_test.cpp.
#include <gtest/gtest.h>

#include <fstream>

#include "image/image.hpp"

namespace cgw::image {
namespace {

std::string page_text() {
    std::ifstream page(CGW_IMAGE_DOCUMENT);
    return {std::istreambuf_iterator<char>(page), {}};
}

TEST(ImageDocument, lists_every_refusal_code_with_its_text) {
    const std::string text = page_text();
    for (unsigned code = 0; code <= 13; ++code) {
        const std::string row =
            "| " + std::to_string(code) + " | " + std::string(to_text(static_cast<Status>(code))) + " |";
        EXPECT_NE(text.find(row), std::string::npos) << row;
    }
}

TEST(ImageDocument, states_the_sizes_and_versions_of_the_layout) {
    const std::string text = page_text();
    EXPECT_NE(text.find("format " + std::to_string(format_major) + "." + std::to_string(format_minor)),
              std::string::npos);
    EXPECT_NE(text.find(std::to_string(minimum_size) + " to " + std::to_string(maximum_size) + " bytes"),
              std::string::npos);
}

}  // namespace
}  // namespace cgw::image
