#include "parameter/catalogue.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <tuple>

#include "base/ascii.hpp"

namespace cgw::parameter {

namespace {

// Walks a name in its comparable form: lower case, without the blanks that stand before a bracket.
class NameWalk {
  public:
    explicit NameWalk(std::string_view name) : rest_(name) {}

    std::optional<char> next() {
        const std::size_t solid = rest_.find_first_not_of(' ');
        if (solid != std::string_view::npos && rest_[solid] == '(') {
            rest_.remove_prefix(solid);
        }
        if (rest_.empty()) {
            return std::nullopt;
        }
        const char c = base::lower(rest_.front());
        rest_.remove_prefix(1);
        return c;
    }

  private:
    std::string_view rest_;
};

bool same_name(std::string_view a, std::string_view b) {
    NameWalk left(a);
    NameWalk right(b);
    while (true) {
        const std::optional<char> l = left.next();
        if (l != right.next()) {
            return false;
        }
        if (!l) {
            return true;
        }
    }
}

bool below(const Row* row, std::uint16_t number) {
    return row->number < number;
}

struct Misprint {
    std::uint16_t number = 0;
    std::string_view name;
};

// "409 CanBaudrate"; number 0 when the text has another form.
Misprint split(std::string_view text) {
    Misprint misprint;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), misprint.number);
    if (error != std::errc{}) {
        return {};
    }
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    const std::size_t start = text.find_first_not_of(' ');
    misprint.name = start == std::string_view::npos ? std::string_view{} : text.substr(start);
    return misprint;
}

}  // namespace

std::size_t Catalogue::NameHash::operator()(std::string_view name) const {
    std::uint64_t hash = 14695981039346656037U;  // FNV-1a
    NameWalk walk(name);
    while (const std::optional<char> c = walk.next()) {
        hash = (hash ^ static_cast<unsigned char>(*c)) * 1099511628211U;
    }
    return static_cast<std::size_t>(hash);
}

bool Catalogue::NameEqual::operator()(std::string_view a, std::string_view b) const {
    return same_name(a, b);
}

std::string_view array_name(const Row& row) {
    return row.array_first == 0 ? row.name : row.name.substr(0, row.name.find('('));
}

Catalogue::Catalogue(std::span<const Row> shipped) {
    for (const Device device : {Device::governor, Device::gateway}) {
        by_number_[index_of(device, Program::application)].reserve(shipped.size());
        by_name_[index_of(device, Program::application)].reserve(shipped.size());
    }
    for (const Row& row : shipped) {
        by_number_[index_of(row.device, row.program)].push_back(&row);
        index_names(row);
    }
}

const Row* Catalogue::find(Device device, std::uint16_t number) const {
    return find(device, Program::application, number);
}

const Row* Catalogue::find(Device device, Program program, std::uint16_t number) const {
    const std::vector<const Row*>& known = rows(device, program);
    const auto place = std::lower_bound(known.begin(), known.end(), number, below);
    return place != known.end() && (*place)->number == number ? *place : nullptr;
}

const Row* Catalogue::find(Device device, std::string_view name) const {
    return find(device, Program::application, name);
}

const Row* Catalogue::find(Device device, Program program, std::string_view name) const {
    const NameIndex& names = by_name_[index_of(device, program)];
    const auto place = names.find(name);
    return place != names.end() ? place->second : nullptr;
}

const Row* Catalogue::find_misprint(Device device, std::uint16_t number, std::string_view name) const {
    if (name.empty() && find(device, number) != nullptr) {
        return nullptr;
    }
    for (const Row* row : rows(device)) {
        for (const std::string_view text : row->misprints) {
            const Misprint misprint = split(text);
            if (misprint.number == number && (name.empty() || same_name(misprint.name, name))) {
                return row;
            }
        }
    }
    return nullptr;
}

const Row* Catalogue::put(const Row& row) {
    Row& kept = added_.emplace_back(row);
    kept.name = keep(row.name);
    kept.aliases = keep(row.aliases);
    kept.misprints = keep(row.misprints);
    kept.unit = keep(row.unit);
    kept.text = keep(row.text);
    kept.used = keep(row.used);
    kept.section = keep(row.section);
    kept.bits = keep(row.bits);
    kept.values = keep(row.values);
    kept.choices = number_lists_.emplace_back(row.choices.begin(), row.choices.end());
    kept.pages = number_lists_.emplace_back(row.pages.begin(), row.pages.end());

    std::vector<const Row*>& rows = by_number_[index_of(row.device, row.program)];
    const auto place = std::lower_bound(rows.begin(), rows.end(), row.number, below);
    if (place != rows.end() && (*place)->number == row.number) {
        forget_names(**place);
        *place = &kept;
    } else {
        rows.insert(place, &kept);
    }
    index_names(kept);
    return &kept;
}

std::vector<const Row*> Catalogue::added() const {
    std::vector<const Row*> result;
    for (const Row& row : added_) {
        if (find(row.device, row.program, row.number) == &row) {  // not replaced since
            result.push_back(&row);
        }
    }
    std::sort(result.begin(), result.end(), [](const Row* a, const Row* b) {
        return std::tie(a->device, a->program, a->number) < std::tie(b->device, b->program, b->number);
    });
    return result;
}

std::vector<std::string_view> Catalogue::names(Device device) const {
    std::vector<std::string_view> result;
    for (const Row* row : rows(device)) {
        if (!row->settable() || row->name.empty()) {
            continue;
        }
        if (row->array_first == row->number) {
            result.push_back(array_name(*row));
        }
        result.push_back(row->name);
    }
    return result;
}

std::string_view Catalogue::keep(std::string_view text) {
    return texts_.emplace_back(text);
}

std::span<const std::string_view> Catalogue::keep(std::span<const std::string_view> texts) {
    std::vector<std::string_view>& list = text_lists_.emplace_back();
    for (const std::string_view text : texts) {
        list.push_back(keep(text));
    }
    return list;
}

std::span<const NamedBit> Catalogue::keep(std::span<const NamedBit> bits) {
    std::vector<NamedBit>& list = bit_lists_.emplace_back();
    for (const NamedBit& bit : bits) {
        list.push_back({bit.bit, keep(bit.name), keep(bit.text)});
    }
    return list;
}

std::span<const NamedValue> Catalogue::keep(std::span<const NamedValue> values) {
    std::vector<NamedValue>& list = value_lists_.emplace_back();
    for (const NamedValue& value : values) {
        list.push_back({value.value, keep(value.text)});
    }
    return list;
}

template <typename Visit>
void Catalogue::each_name(const Row& row, Visit visit) {
    if (!row.name.empty()) {
        visit(row.name);
    }
    if (row.array_first != 0 && row.array_first == row.number) {
        visit(array_name(row));
    }
    for (const std::string_view alias : row.aliases) {
        visit(alias);
    }
}

void Catalogue::index_names(const Row& row) {
    NameIndex& names = by_name_[index_of(row.device, row.program)];
    each_name(row, [&](std::string_view name) { names.try_emplace(name, &row); });
}

void Catalogue::forget_names(const Row& row) {
    NameIndex& names = by_name_[index_of(row.device, row.program)];
    each_name(row, [&](std::string_view name) {
        const auto place = names.find(name);
        if (place != names.end() && place->second == &row) {
            names.erase(place);
        }
    });
}

}  // namespace cgw::parameter
