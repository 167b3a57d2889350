// An archive in memory: adding and finding arrays and values.
#include "scree/output/archive.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "scree/base/error.h"

namespace scree {

void Archive::add(ArchivedArray array) {
  if (contains(array.name) || array.name.empty() || array.name.find('/') != std::string::npos)
    throw std::logic_error(fmt::format("archive name '{}' is taken or impossible", array.name));
  arrays_.push_back(std::move(array));
}

void Archive::put_shared(std::span<const std::string> names, const Slab& slab) {
  for (std::size_t k = 0; k < names.size(); ++k)
    add({names[k], slab.columns[k], slab.owner, true, slab.first, slab.total});
}

void Archive::set(std::string name, ArchivedValue value) {
  if (contains(name) || name.empty() || name.find('/') != std::string::npos)
    throw std::logic_error(fmt::format("archive name '{}' is taken or impossible", name));
  values_.emplace_back(std::move(name), std::move(value));
}

void Archive::add_all(const Archive& other) {
  for (const ArchivedArray& array : other.arrays_) add(array);
  for (const auto& [name, value] : other.values_) set(name, value);
}

bool Archive::contains(const std::string& name) const {
  return std::ranges::any_of(arrays_, [&](const auto& array) { return array.name == name; }) ||
         std::ranges::any_of(values_, [&](const auto& entry) { return entry.first == name; });
}

bool Archive::is_cut(const std::string& name) const {
  const auto found = std::ranges::find(arrays_, name, &ArchivedArray::name);
  return found->shared && found->values.rows < found->total;
}

const ArrayView& Archive::find(const std::string& name, Element element, std::uint64_t columns) const {
  const auto found = std::ranges::find(arrays_, name, &ArchivedArray::name);
  if (found == arrays_.end()) throw InputError(fmt::format("{} holds no array '{}'", origin, name));
  const ArrayView& values = found->values;
  if (values.element != element || values.columns != columns)
    throw InputError(fmt::format("{}: array '{}' holds {} in {} columns, expected {} in {}", origin, name,
                                 element_name(values.element), values.columns, element_name(element), columns));
  return values;
}

template <class T>
const T& Archive::value(const std::string& name, const char* type) const {
  for (const auto& [key, entry] : values_) {
    if (key != name) continue;
    if (const T* found = std::get_if<T>(&entry)) return *found;
    throw InputError(fmt::format("{}: value '{}' is not {}", origin, name, type));
  }
  throw InputError(fmt::format("{} holds no value '{}'", origin, name));
}

double Archive::number(const std::string& name) const { return value<double>(name, "a number"); }
std::int64_t Archive::integer(const std::string& name) const { return value<std::int64_t>(name, "an integer"); }
const std::string& Archive::text(const std::string& name) const { return value<std::string>(name, "a text"); }

}  // namespace scree
