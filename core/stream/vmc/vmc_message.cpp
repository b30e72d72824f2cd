#include "core/stream/vmc/vmc_message.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/text.hpp"

namespace abrazo {

namespace {

using Issues = std::vector<StreamIssue>;

std::string at(const OscElement& message) {
  return "byte " + std::to_string(message.offset) + ": " + message.address;
}

bool is_number(char type) {
  return type == 'f' || type == 'd' || type == 'i' || type == 'h';
}

/// The arguments of one message against the types that its address demands. Further arguments are ignored.
class Arguments {
 public:
  Arguments(const OscElement& message, Issues& issues) : message_(message), issues_(issues) {}

  /// @param types  's', 'i' or 'f' for each; for 'f' other numbers are taken too, and counted
  bool are(std::string_view types) {
    if (message_.arguments.size() < types.size()) {
      issues_.push_back({"too-few-arguments", at(message_) + " has " +
                                                  std::to_string(message_.arguments.size()) +
                                                  " arguments; expected '" + std::string(types) + "'"});
      return false;
    }
    for (std::size_t i = 0; i < types.size(); ++i) {
      const char type = message_.arguments[i].type;
      const bool fits = types[i] == 's'   ? type == 's' || type == 'S'
                        : types[i] == 'i' ? type == 'i' || type == 'h' || type == 'T' || type == 'F'
                                          : is_number(type);
      if (!fits) {
        issues_.push_back({"wrong-types", at(message_) + " has types '" + found() + "'; expected '" +
                                              std::string(types) + "'"});
        return false;
      }
    }
    if (std::any_of(types.begin(), types.end(), [&, i = std::size_t{0}](char type) mutable {
          return message_.arguments[i++].type != 'f' && type == 'f';
        }))
      issues_.push_back({"other-numbers", at(message_) + " has types '" + found() + "' where '" +
                                              std::string(types) + "' is due; they are taken as they are"});
    return true;
  }

  double number(std::size_t i) const { return message_.arguments[i].number; }
  const std::string& text(std::size_t i) const { return message_.arguments[i].text; }
  Vec3 vector(std::size_t i) const { return {number(i), number(i + 1), number(i + 2)}; }
  bool has_floats(std::size_t from, std::size_t count) const {
    if (message_.arguments.size() < from + count) return false;
    for (std::size_t i = from; i < from + count; ++i)
      if (!is_number(message_.arguments[i].type)) return false;
    return true;
  }

  /// Seven numbers from `i` on. Nothing when one of them is not finite.
  std::optional<VmcTransform> transform(std::size_t i, const std::string& name) {
    const Vec3 position = vector(i);
    const Eigen::Quaterniond rotation(number(i + 6), number(i + 3), number(i + 4), number(i + 5));
    if (!position.allFinite() || !rotation.coeffs().allFinite()) {
      issues_.push_back({"not-finite", at(message_) + " " + name +
                                           ": a number is infinite or not a number; " +
                                           "what came before is kept"});
      return std::nullopt;
    }
    VmcTransform transform{mirrored(position), std::nullopt};
    const double norm = rotation.norm();
    if (norm < 0.5 || norm > 1.5)
      issues_.push_back({norm < 1e-3 ? "zero-rotation" : "bad-rotation",
                         at(message_) + " " + name + ": the quaternion has length " + exact_text(norm) +
                             "; expected 1 (0.5 to 1.5 is taken). The rotation that came before is kept"});
    else
      transform.rotation = mirrored(rotation.normalized());
    return transform;
  }

  void not_finite() {
    issues_.push_back({"not-finite", at(message_) + ": a number is infinite or not a number"});
  }

 private:
  std::string found() const {
    std::string types;
    for (const OscArgument& argument : message_.arguments)
      if (types.size() < 20) types += argument.type;
    return types;
  }

  const OscElement& message_;
  Issues& issues_;
};

std::optional<VmcMessage> read_bone(Arguments& arguments) {
  if (!arguments.are("sfffffff")) return std::nullopt;
  const auto local = arguments.transform(1, arguments.text(0).substr(0, 40));
  if (!local) return std::nullopt;
  return VmcBone{arguments.text(0), *local};
}

std::optional<VmcMessage> read_root(Arguments& arguments) {
  if (!arguments.are("sfffffff")) return std::nullopt;
  const auto world = arguments.transform(1, "root");
  if (!world) return std::nullopt;
  VmcRoot root{*world};
  if (arguments.has_floats(8, 6)) {
    root.scale = arguments.vector(8);
    root.offset = mirrored(arguments.vector(11));
    if (!root.scale.allFinite() || !root.offset.allFinite()) {
      arguments.not_finite();
      return std::nullopt;
    }
  }
  return root;
}

std::optional<VmcMessage> read_time(Arguments& arguments) {
  if (!arguments.are("f")) return std::nullopt;
  if (std::isfinite(arguments.number(0))) return VmcTime{arguments.number(0)};
  arguments.not_finite();
  return std::nullopt;
}

int state_number(double value) {
  return static_cast<int>(std::clamp(value, -1.0, 1e6));
}

std::optional<VmcMessage> read_ok(const OscElement& message, Arguments& arguments) {
  constexpr std::array<std::string_view, 4> forms = {"i", "i", "iii", "iiii"};
  const std::size_t form = std::min<std::size_t>(message.arguments.size(), 4);
  if (!arguments.are(forms[form == 0 ? 0 : form - 1])) return std::nullopt;
  VmcOk ok;
  ok.loaded = state_number(arguments.number(0));
  if (form >= 3) ok.calibration = state_number(arguments.number(1));
  if (form >= 4) ok.tracking = state_number(arguments.number(3));
  return ok;
}

std::optional<VmcMessage> read_end(Arguments& arguments) {
  if (!arguments.are("sfff")) return std::nullopt;
  const Vec3 local = mirrored(arguments.vector(1));
  if (local.allFinite()) return VmcEnd{arguments.text(0), local};
  arguments.not_finite();
  return std::nullopt;
}

std::vector<OscArgument> named_transform(const std::string& name, const Vec3& position,
                                         const Eigen::Quaterniond& rotation) {
  const Vec3 p = mirrored(position);
  const Eigen::Quaterniond q = mirrored(rotation);
  std::vector<OscArgument> arguments = {OscArgument::of(name)};
  for (const double value : {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()})
    arguments.push_back(OscArgument::of(static_cast<float>(value)));
  return arguments;
}

}  // namespace

std::optional<VmcMessage> read_vmc(const OscElement& message, Issues& issues) {
  Arguments arguments(message, issues);
  if (message.address == "/VMC/Ext/Bone/Pos") return read_bone(arguments);
  if (message.address == "/VMC/Ext/Root/Pos") return read_root(arguments);
  if (message.address == "/VMC/Ext/T") return read_time(arguments);
  if (message.address == "/VMC/Ext/OK") return read_ok(message, arguments);
  if (message.address == vmc_end_address) return read_end(arguments);
  if (message.address == "/VMC/Ext/VRM") {
    if (!arguments.are("ss")) return std::nullopt;
    return VmcModel{arguments.text(1)};
  }
  return VmcOther{};
}

Vec3 mirrored(const Vec3& position) {
  return {-position.x(), position.y(), position.z()};
}

Eigen::Quaterniond mirrored(const Eigen::Quaterniond& rotation) {
  return {rotation.w(), rotation.x(), -rotation.y(), -rotation.z()};
}

OscElement vmc_bone_message(const std::string& name, const Vec3& position,
                            const Eigen::Quaterniond& rotation) {
  return osc_message("/VMC/Ext/Bone/Pos", named_transform(name, position, rotation));
}

OscElement vmc_root_message(const Vec3& position, const Eigen::Quaterniond& rotation) {
  std::vector<OscArgument> arguments = named_transform("root", position, rotation);
  for (const float number : {1.F, 1.F, 1.F, 0.F, 0.F, 0.F}) arguments.push_back(OscArgument::of(number));
  return osc_message("/VMC/Ext/Root/Pos", arguments);
}

OscElement vmc_end_message(const std::string& bone, const Vec3& local) {
  const Vec3 p = mirrored(local);
  return osc_message(vmc_end_address, {OscArgument::of(bone), OscArgument::of(static_cast<float>(p.x())),
                                       OscArgument::of(static_cast<float>(p.y())),
                                       OscArgument::of(static_cast<float>(p.z()))});
}

}  // namespace abrazo
