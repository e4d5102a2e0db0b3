#include "authoring/new_file.hpp"
#include "catalogue/catalogue.hpp"
#include "cli/cgw/output_file.hpp"
#include "cli/cgw/verbs.hpp"

namespace cgw::cli {
namespace {

constexpr Option new_options[] = {
    text_output_option,
    title_option,
    force_option,
};

int run_new(const Arguments& arguments) {
    const std::string output = arguments.value("--output");
    const std::string title = title_of(arguments);
    refuse_existing_output(arguments, output);
    const parameter::Catalogue catalogue(catalogue::shipped_rows());
    return write_text(output, schema_line(output) + authoring::new_file_text(title, catalogue));
}

}  // namespace

const Verb new_verb = {"new", "write a commented parameter file to begin with", new_options, run_new,
                       "The file holds what most plants need. Values that nobody can guess, bit rates\n"
                       "and node ids, are marked FILL IN; cgw check names those that are missing."};

}  // namespace cgw::cli
