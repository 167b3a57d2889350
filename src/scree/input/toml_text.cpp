// One overload for each kind of value.
#include "scree/input/toml_text.h"

#include <fmt/format.h>

namespace scree {
namespace {

struct Writer {
  const Key& key;

  std::string text(double x) const { return fmt::format("{}", x); }
  std::string text(std::uint64_t x) const { return fmt::format("{}", x); }
  std::string text(bool x) const { return x ? "true" : "false"; }
  std::string text(const std::string& x) const { return quoted(x); }
  std::string text(int x) const { return quoted(key.choices.at(x)); }

  template <class Range>
  std::string list(const Range& items) const {
    std::string out = "[";
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (i > 0) out += ", ";
      out += text(items[i]);
    }
    return out + "]";
  }
  template <class T, std::size_t n>
  std::string text(const std::array<T, n>& items) const {
    return list(items);
  }
  std::string text(const std::vector<bool>&) const = delete;
  template <class T>
  std::string text(const std::vector<T>& items) const {
    return list(items);
  }
};

}  // namespace

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < ' ' || c == 127)
      out += fmt::format("\\u{:04X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    else
      out += c;
  }
  return out + "\"";
}

std::optional<std::string> toml_text(const Key& key, void* keys) {
  const Writer writer{key};
  return std::visit(
      [&](const auto& slot) -> std::optional<std::string> {
        using SlotType = std::decay_t<decltype(slot)>;
        if constexpr (std::is_same_v<SlotType, Nested> || std::is_same_v<SlotType, NestedList>) {
          return std::nullopt;
        } else if constexpr (std::is_same_v<SlotType, Get<std::optional<double>>>) {
          const std::optional<double>& value = slot(keys);
          if (value) return writer.text(*value);
          return key.word.empty() ? std::nullopt : std::optional(quoted(key.word));
        } else {
          return writer.text(slot(keys));
        }
      },
      key.slot);
}

std::string default_of(const Section& section, const Key& key) {
  if (key.is_required) return "";
  if (!key.default_text.empty()) return key.default_text;
  if (std::holds_alternative<Nested>(key.slot)) return "as its keys say";
  if (std::holds_alternative<NestedList>(key.slot)) return "none";
  return toml_text(key, section.make().get()).value_or("none");
}

}  // namespace scree
