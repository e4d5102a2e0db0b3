// The document while it grows: what may follow what (a key once, a table opened once, TOML 1.0).
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "toml/complaint.hpp"
#include "toml/document.hpp"

namespace cgw::toml {

// One part of a key or header, quotes and escapes undone.
struct KeyPart {
    std::string text;
    diagnostic::Range range;
};

class Tree {
  public:
    using Id = std::uint32_t;
    static constexpr Id root = 0;

    Tree();

    // [a.b] and [[a.b]]; `header` is the range with its brackets. Throws Complaint.
    Id open_table(std::span<const KeyPart> path, const diagnostic::Range& header);
    Id open_array_element(std::span<const KeyPart> path, const diagnostic::Range& header);

    // a.b = …, relative to `table`; the value is filled in through value(). Throws Complaint.
    Id add(Id table, std::span<const KeyPart> path);

    // One more element of the array `array`.
    Id append(Id array, const diagnostic::Range& where);

    // Kind, range and content; children are added with add() and append().
    Node& value(Id id) { return items_[id].entry.value; }

    // Call once.
    Node take();

  private:
    // How a table or array came to be decides what may still be added to it.
    enum class Origin { value, dotted, implied_by_header, implied_by_array_header, header, array_of_tables };

    struct Item {
        Entry entry;
        Origin origin = Origin::value;
        std::uint32_t depth = 0;
        diagnostic::Range opened_by;  // the header that made or implied it
        std::vector<Id> children;
    };

    struct Place {
        Id table;
        std::string key;

        friend bool operator==(const Place&, const Place&) = default;
    };
    struct PlaceHash {
        std::size_t operator()(const Place& place) const;
    };

    const Id* find(Id table, const std::string& key) const;
    Id create(Id parent, const KeyPart& part, Origin origin, const diagnostic::Range& opened_by);
    Id parent_of_header(std::span<const KeyPart> path, const diagnostic::Range& header, bool is_array);
    Node assemble(Id id);

    std::deque<Item> items_;
    std::unordered_map<Place, Id, PlaceHash> index_;
};

}  // namespace cgw::toml
