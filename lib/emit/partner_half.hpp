// The partner's half of a plant before it is written in any language.
#pragma once

#include "emit/emitter.hpp"
#include "partner/half.hpp"

namespace cgw::emit {

partner::Half partner_half(const Plant& plant);

}  // namespace cgw::emit
