#include "bench/eds_stages.hpp"

#include <fmt/format.h>

#include <array>

#include "eds/writer.hpp"
#include "eds_check/fix.hpp"

namespace cgw::bench {
namespace {

const std::string path = "bench.eds";

// Every fourth object is a record of two entries; each begins with a value that follows the node number.
dictionary::Dictionary dictionary_of(unsigned objects) {
    dictionary::Dictionary dictionary;
    for (unsigned i = 0; i < objects; ++i) {
        dictionary::Object& object = dictionary.objects.emplace_back();
        object.index = static_cast<std::uint16_t>(0x1000 + i);
        object.name = fmt::format("Object number {}", i);
        const bool is_record = i % 4 == 3;
        object.code = is_record ? object::ObjectCode::record : object::ObjectCode::var;
        for (std::uint8_t sub = 0; sub < (is_record ? 3 : 1); ++sub) {
            dictionary::Variable& variable = object.variables.emplace_back();
            variable.sub_index = sub;
            variable.name = fmt::format("Entry number {}", sub);
            variable.type = object::DataType::unsigned32;
            variable.default_value = {0x180 + i, sub == 0 && i % 2 == 0};
        }
    }
    return dictionary;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    std::string result;
    std::size_t at = 0;
    for (std::size_t found = text.find(from); found != std::string::npos; found = text.find(from, at)) {
        result.append(text, at, found - at).append(to);
        at = found + from.size();
    }
    return result.append(text, at);
}

std::size_t check(const EdsSample& sample) {
    diagnostic::Findings findings;
    const eds::Document document(sample.text);
    const eds::Sheet sheet = eds::read(document, path, findings);
    eds_check::check(document, sheet, path, {.file_name = path}, findings);
    findings.sort();
    return findings.all().size();
}

std::size_t read(const EdsSample& sample) {
    diagnostic::Findings findings;
    const eds::Document document(sample.text);
    return eds::read(document, path, findings).dictionary.objects.size() + findings.all().size();
}

constexpr std::array stages{
    EdsStage{"document",
             [](const EdsSample& sample) { return eds::Document(sample.text).sections().size(); }},
    EdsStage{"read", read},
    EdsStage{"check", check},
    EdsStage{"fix",
             [](const EdsSample& sample) {
                 return eds_check::fix(sample.broken, path, {.file_name = path}).repairs.size();
             }},
    EdsStage{"write", [](const EdsSample& sample) { return eds::write(sample.dictionary).size(); }},
};

}  // namespace

EdsSample::EdsSample(unsigned objects)
    : dictionary(dictionary_of(objects)),
      text(eds::write(dictionary)),
      broken(replaced(replaced(text, "SubNumber=3", "SubNumber=9"), "$NODEID+", "$NodeId + ")) {}

std::span<const EdsStage> eds_stages() {
    return stages;
}

}  // namespace cgw::bench
