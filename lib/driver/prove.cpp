#include "driver/prove.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/files.hpp"
#include "dbc/read.hpp"
#include "diagnostic/rules/eds.hpp"
#include "driver/check_sheet.hpp"
#include "driver/device_description.hpp"
#include "driver/report_unreadable.hpp"
#include "image/area.hpp"

namespace cgw::driver {
namespace {

class Prover {
  public:
    explicit Prover(const emit::Plant& plant) : plant_(plant) {}

    Proofs run(const Artefacts& artefacts) {
        for (const std::string& path : artefacts.descriptions) {
            prove_description(path);
        }
        for (const std::string& path : artefacts.images) {
            prove_image(path);
        }
        for (const std::string& path : artefacts.databases) {
            prove_database(path);
        }
        return std::move(proofs_);
    }

  private:
    // Errors for strict importers only: the file can be read and compared all the same.
    static std::size_t strict_errors(const diagnostic::Findings& findings) {
        const auto& all = findings.all();
        return static_cast<std::size_t>(
            std::count_if(all.begin(), all.end(), [](const diagnostic::Diagnostic& finding) {
                return finding.promoted && finding.rule->level != diagnostic::Level::error;
            }));
    }

    // False when the file's errors leave nothing to compare.
    bool usable(const std::string& path, diagnostic::Findings findings) {
        findings.sort();
        proofs_.has_errors = proofs_.has_errors || findings.has_errors();
        const bool errors = findings.count(diagnostic::Level::error) > strict_errors(findings);
        if (!findings.all().empty()) {
            proofs_.reports.push_back({path, findings.all()});
        }
        return !errors;
    }

    void add(const std::string& path, std::string_view kind, proof::Proof proof) {
        proof.path = path;
        proof.kind = kind;
        proofs_.all.push_back(std::move(proof));
    }

    void prove_description(const std::string& path) {
        auto description = read_device_description(path);
        if (!description) {  // SOURCE_DATE_EPOCH, which concerns parameter files only
            return;
        }
        proofs_.unreadable = proofs_.unreadable || description->unreadable;
        if (is_eds(description->kind) && description->valid()) {
            description->findings =
                check_data_sheet_text(path, description->sources[path], {.strict = true}).findings;
        }
        if (is_of_any_device(description->kind) && !is_eds(description->kind)) {
            description->findings.promote_warnings();  // importers of the other dialect take another value
        }
        if (!is_of_any_device(description->kind)) {
            description->findings.report(
                {&diagnostic::rules::eds_text,
                 fmt::format("this is a {}, and no EDS, DCF, XDD or XDC", to_text(description->kind)),
                 {path, {}}});
        }
        proofs_.sources.merge(description->sources);
        const std::size_t refused = strict_errors(description->findings);
        if (usable(path, std::move(description->findings))) {
            const auto& node = description->commissioning;
            add(path, to_text(description->kind),
                proof::prove_description(plant_, {description->dictionary, node ? &*node : nullptr}));
            proofs_.all.back().strict_errors = refused;
        }
    }

    std::optional<std::string> read(const std::string& path, std::size_t limit) {
        base::Result<std::string> text = base::read_file(path, limit);
        if (text) {
            return std::move(*text);
        }
        diagnostic::Findings findings;
        proofs_.unreadable = report_unreadable(path, text.error(), findings) || proofs_.unreadable;
        usable(path, std::move(findings));
        return std::nullopt;
    }

    void prove_image(const std::string& path) {
        const std::optional<std::string> text = read(path, eds::largest_text);
        if (!text) {
            return;
        }
        const base::Bytes bytes = base::to_bytes(*text);
        image::Image image;
        diagnostic::Findings findings;
        if (const image::Status status = image::Image::open(image::image_in(bytes), image);
            status != image::Status::ok) {
            report_refused(path, status, findings);
        }
        if (usable(path, std::move(findings))) {
            add(path, "image", proof::prove_image(plant_, image));
        }
    }

    void prove_database(const std::string& path) {
        std::optional<std::string> text = read(path, dbc::largest_text);
        if (!text) {
            return;
        }
        diagnostic::Findings findings;
        const dbc::Database database = dbc::read(*text, path, findings);
        proofs_.sources[path] = std::move(*text);
        if (usable(path, std::move(findings))) {
            add(path, "DBC", proof::prove_database(plant_, database));
        }
    }

    const emit::Plant& plant_;
    Proofs proofs_;
};

}  // namespace

Proofs prove(const emit::Plant& plant, const Artefacts& artefacts) {
    return Prover(plant).run(artefacts);
}

}  // namespace cgw::driver
