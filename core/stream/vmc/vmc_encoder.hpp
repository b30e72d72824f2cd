#pragma once

#include <memory>

#include "core/base/result.hpp"
#include "core/motion/body/body.hpp"
#include "core/stream/protocol/stream_encoder.hpp"
#include "core/stream/protocol/stream_uri.hpp"

namespace abrazo {

/// Encodes a character as VMC protocol 2.7: Unity's humanoid bones with rotations from a T-pose, root, OK and
/// T. Option "framing": "t-last" (one bundle that ends with T), "t-first" (one that begins with it, as
/// SlimeVR) or "split" (as the VMC application: bundles of at most 12 bones, the last one with T). Option
/// "root": "character" (as the VMC application: the root has the character's place on the floor and its
/// heading, the hips are relative to it) or "origin" (the root does not move). See docs/guide/live/vmc.md.
/// @param body of the character, for the offsets of the bones
/// @return an Error if an option or the body is invalid
Result<std::unique_ptr<StreamEncoder>> make_vmc_encoder(const StreamUri& uri, const Body& body);

}  // namespace abrazo
