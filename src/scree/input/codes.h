// The codes of errors in a case. A code keeps its meaning for ever; new ones are added.
#pragma once

#include <span>
#include <string_view>

namespace scree {

struct ErrorCode {
  std::string_view code, title, text;
};

/// Every code, in order.
std::span<const ErrorCode> error_codes();

}  // namespace scree
