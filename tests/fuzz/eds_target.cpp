// Any bytes are read for an EDS or DCF: written back they are the same, every finding stands in the text,
// repairs are complete at once, and what could be read is written so that it reads back as the same device.
#include "driver/check_sheet.hpp"
#include "eds/edit.hpp"
#include "eds/writer.hpp"
#include "fuzz/fuzz.hpp"

namespace cgw::fuzz {
namespace {

const std::string path = "device.eds";

void demand_fixed(const std::string& text) {
    const eds_check::Options options{.file_name = path};
    const eds_check::Fixed once = eds_check::fix(text, path, options);
    demand(once.doubts.all().empty() || once.text == text, "a file in doubt stays as it is");
    demand(once.text == text || !once.repairs.empty(), "what is repaired is told");
    const eds_check::Fixed twice = eds_check::fix(once.text, path, options);
    demand(twice.text == once.text && twice.repairs.empty(), "a repaired file has nothing to repair");
}

std::string written(const eds::Sheet& sheet) {
    return sheet.commissioning ? eds::write(sheet.dictionary, *sheet.commissioning)
                               : eds::write(sheet.dictionary);
}

void demand_written(const driver::DataSheet& file) {
    const std::string text = written(*file.sheet);
    const driver::DataSheet again = driver::read_data_sheet_text(path, text);
    demand(again.valid(), "what is written can be read");
    demand(written(*again.sheet) == text, "what is written reads back as the same device");
    const auto& before = file.sheet->dictionary.objects;
    const auto& after = again.sheet->dictionary.objects;
    demand(before.size() == after.size(), "no object is lost");
    for (std::size_t i = 0; i < before.size(); ++i) {
        demand(before[i].index == after[i].index && before[i].code == after[i].code &&
                   before[i].variables.size() == after[i].variables.size(),
               "an object stays the same");
    }
}

}  // namespace

void eds(Input input) {
    const std::string text(input.begin(), input.end());
    const eds::Document document(text);
    demand(eds::Edits(document).apply() == text, "a file is written back as it is");
    const driver::DataSheet checked =
        driver::check_data_sheet_text(path, text, {.strict = sometimes(input, 4)});
    demand_sound({.path = path, .findings = checked.findings.all()}, checked.sources);
    demand_fixed(text);
    const driver::DataSheet file = driver::read_data_sheet_text(path, text);
    if (file.valid()) {
        demand_written(file);
    }
}

}  // namespace cgw::fuzz
