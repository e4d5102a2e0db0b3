// Inside the xdd room: an XML text with the place of every element and attribute. pugixml knows where an
// element begins, not where its attributes are; those are looked up in the text when a finding needs them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostic/diagnostic.hpp"
#include "dictionary/data_types.hpp"
#include "dictionary/dictionary.hpp"

namespace cgw::xdd {

// The name of an element or attribute behind its prefix.
std::string_view local_name(const char* name);

class Source {
  public:
    // At most largest_text bytes; what is not UTF-8 is taken as Latin-1.
    Source(std::string_view text, const std::string& path, diagnostic::Findings& findings);

    // False after a finding, when the text is not well-formed.
    bool parse();
    pugi::xml_node root() const { return document_.document_element(); }
    std::size_t length() const { return text_.size(); }  // in UTF-8

    void report(const diagnostic::Rule& rule, pugi::xml_node element, std::string message,
                std::string help = "");
    void report(const diagnostic::Rule& rule, pugi::xml_node element, pugi::xml_attribute attribute,
                std::string message, std::string help = "");
    void report_whole_file(const diagnostic::Rule& rule, std::string message, std::string help = "");
    // Tells how many findings were not told one by one.
    void finish();

    // The first child element of that name; none is an empty node.
    static pugi::xml_node child(pugi::xml_node of, std::string_view name);

    // Calls `take(element)` for each child element of that name.
    template <typename Take>
    static void each_child(pugi::xml_node of, std::string_view name, Take take) {
        for (const pugi::xml_node child : of.children()) {
            if (child.type() == pugi::node_element && local_name(child.name()) == name) {
                take(child);
            }
        }
    }

    // Of an attribute that is there and not empty. Nothing after a finding, when it is no such value.

    std::optional<std::uint64_t> number(pugi::xml_node element, const char* name, std::uint64_t highest);
    std::optional<std::uint64_t> hexadecimal(pugi::xml_node element, const char* name, std::uint64_t highest);
    std::optional<bool> flag(pugi::xml_node element, const char* name);
    // A string may be empty.
    std::optional<dictionary::Value> value(pugi::xml_node element, const char* name,
                                           const dictionary::TypeRow& type);

  private:
    void add(const diagnostic::Rule& rule, const diagnostic::Range& range, std::string message,
             std::string help);
    diagnostic::Position position(std::size_t offset) const;
    diagnostic::Range range_of(pugi::xml_node element) const;
    diagnostic::Range range_of(pugi::xml_node element, pugi::xml_attribute attribute) const;
    std::optional<dictionary::Value> numeric(pugi::xml_node element, pugi::xml_attribute attribute,
                                             const dictionary::TypeRow& type);
    std::optional<dictionary::Value> real(pugi::xml_node element, pugi::xml_attribute attribute,
                                          const dictionary::TypeRow& type);
    std::optional<dictionary::Value> octets(pugi::xml_node element, pugi::xml_attribute attribute);
    void refuse(pugi::xml_node element, pugi::xml_attribute attribute, std::string_view why);
    void refuse_range(pugi::xml_node element, pugi::xml_attribute attribute, const std::string& why);

    std::string text_;  // UTF-8
    bool from_latin_1_;
    const std::string& path_;
    diagnostic::Findings& findings_;
    pugi::xml_document document_;
    std::vector<std::size_t> lines_;  // where each begins
    std::map<const diagnostic::Rule*, std::size_t> counts_;
};

// "name is `value`", printable and not too long.
std::string quoted(pugi::xml_attribute attribute);
std::string quoted(std::string_view text);

}  // namespace cgw::xdd
