// What all parts of the reader share: the document, and how entries are looked up, understood and complained
// about.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "diagnostic/diagnostic.hpp"
#include "dictionary/data_types.hpp"
#include "dictionary/dictionary.hpp"
#include "eds/document.hpp"
#include "eds/number.hpp"
#include "eds/section_names.hpp"

namespace cgw::eds {

// One key of a kind of section; `id` is an enumerator of that kind's keys.
struct KeyRow {
    std::string_view name;
    std::uint8_t id = 0;
    bool misspelt = false;  // not what CiA 306 calls it, and read as if it were
};

constexpr KeyRow row(std::string_view name, auto id, bool misspelt = false) {
    return {name, static_cast<std::uint8_t>(id), misspelt};
}

// Lines of the keys of one section, by id; 0: not there, for line 0 is never an entry of a section.
class KeyLines {
  public:
    template <typename Id>
    std::uint32_t operator[](Id id) const {
        return lines_[static_cast<std::size_t>(id)];
    }
    std::uint32_t& at(std::uint8_t id) { return lines_[id]; }

  private:
    std::array<std::uint32_t, 20> lines_{};
};

class Reading {
  public:
    Reading(const Document& of_document, const SectionTable& of_sections, const std::string& path,
            diagnostic::Findings& findings, std::size_t most)
        : document(of_document), sections(of_sections), path_(path), findings_(findings), most_(most) {}

    const Document& document;
    const SectionTable& sections;

    void report(const diagnostic::Rule& rule, const Span& span, std::string message, std::string help = "",
                std::vector<diagnostic::Related> related = {});
    void report_whole_file(const diagnostic::Rule& rule, std::string message);
    // Tells how many findings were not told one by one.
    void finish();

    diagnostic::Location location(const Span& span) const { return {path_, document.range(span)}; }
    const Section& section(std::uint32_t number) const { return document.sections()[number]; }
    std::string quoted(const Section& of) const;  // [name], printable
    std::string quoted_value(std::uint32_t line) const;

    // Where the keys of these rows stand; a key that stands there twice is a finding, the first counts.
    KeyLines key_lines(const Section& of, std::span<const KeyRow> rows);

    // Of the entry on `line`; 0 is a key that is not there. Nothing, like an empty value: not stated, or not
    // readable, which is then a finding.

    std::optional<std::uint64_t> number(std::uint32_t line, std::uint64_t highest) {
        return line != 0 ? stated_number(line, highest) : std::nullopt;
    }
    std::optional<dictionary::Value> value(std::uint32_t line, const dictionary::TypeRow& type);
    std::string text(std::uint32_t line) const {
        return line != 0 ? std::string(document.value(line)) : std::string();
    }
    void assign_text(std::uint32_t line, std::string& to) const {
        if (line != 0) {
            to = document.value(line);
        }
    }

    template <typename Integer>
    void assign(std::uint32_t line, std::uint64_t highest, Integer& to) {
        if (const auto read = number(line, highest)) {
            to = static_cast<Integer>(*read);
        }
    }
    void assign_flag(std::uint32_t line, bool& to) {
        if (const auto read = number(line, 1)) {
            to = *read != 0;
        }
    }

    // Calls `take(number, line)` for each entry whose key is a decimal number; in file order.
    template <typename Take>
    void numbered(const Section& section, Take take) {
        for (std::uint32_t line = section.header + 1; line < section.end; ++line) {
            const std::optional<std::uint32_t> key = entry_number(line);
            if (key) {
                take(*key, line);
            }
        }
    }

    // Of an entry whose key is a decimal number.
    std::optional<std::uint32_t> entry_number(std::uint32_t line) const;

    std::size_t variables = 0;  // so far, of all objects

  private:
    std::optional<std::uint64_t> stated_number(std::uint32_t line, std::uint64_t highest);
    // A number that was read; false when it was none, which is a finding then.
    bool judge(const Number& number, std::uint32_t line) {
        const bool plain = number.reading != Number::Reading::none && !number.loose && !number.misplaced;
        return plain || complain(number, line);
    }
    bool complain(const Number& number, std::uint32_t line);
    void report_formula(std::uint32_t line, const dictionary::TypeRow& type);
    void report_too_large(std::uint32_t line, const dictionary::TypeRow& type);
    std::optional<dictionary::Value> numeric(std::uint32_t line, const dictionary::TypeRow& type);
    std::optional<dictionary::Value> real(std::uint32_t line, const dictionary::TypeRow& type);
    std::optional<dictionary::Value> octets(std::uint32_t line);
    std::optional<dictionary::Value> structure(std::uint32_t line, const dictionary::TypeRow& type);
    std::optional<dictionary::Value> string(std::uint32_t line, const dictionary::TypeRow& type);

    const std::string& path_;
    diagnostic::Findings& findings_;
    std::size_t most_;  // findings of one kind that are told one by one
    std::map<const diagnostic::Rule*, std::size_t> counts_;
};

inline constexpr std::uint64_t highest_u8 = 0xFF;
inline constexpr std::uint64_t highest_u16 = 0xFFFF;
inline constexpr std::uint64_t highest_u32 = 0xFFFFFFFF;

// The parts of the reader; each in the file of its name.

void judge_free_keys(Reading& reading);                                           // judge_keys.cpp
void read_file_information(Reading& reading, dictionary::FileInformation& file);  // read_information.cpp
void read_device_information(Reading& reading, dictionary::DeviceInformation& device);
void read_dummy_usage(Reading& reading, std::vector<std::uint8_t>& dummies);
void read_comments(Reading& reading, std::uint32_t number, std::vector<std::string>& comments);
std::optional<dictionary::Commissioning> read_commissioning(Reading& reading);

// All objects of the device (`module` 0) or of a module.
std::vector<dictionary::Object> read_objects(Reading& reading, std::uint8_t module);  // read_objects.cpp
// What a section says of one variable; nothing when its type or access cannot be read.
std::optional<dictionary::Variable> read_variable(Reading& reading,
                                                  std::uint32_t section);  // read_variable.cpp

// Variables for CompactSubObj, and what [xxxxName], [xxxxValue] and [xxxxDenotation] say of them.
void add_compact_variables(Reading& reading, std::uint32_t section, std::uint8_t count,
                           dictionary::Object& object);  // read_compact.cpp
void read_compact_entries(Reading& reading, std::uint32_t section, dictionary::Object& object);
// PDO parameters that CompactPDO implies.
void add_compact_pdos(const dictionary::DeviceInformation& device, std::vector<dictionary::Object>& objects);

void read_modules(Reading& reading, std::vector<dictionary::Module>& modules);  // read_modules.cpp

}  // namespace cgw::eds
