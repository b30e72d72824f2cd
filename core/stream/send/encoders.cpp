#include "core/stream/send/encoders.hpp"

#include "core/stream/natnet/natnet_encoder.hpp"
#include "core/stream/vmc/vmc_encoder.hpp"
#include "core/stream/xsens/xsens_encoder.hpp"

namespace abrazo {

Result<std::unique_ptr<StreamEncoder>> make_stream_encoder(const StreamUri& uri, const Body& body) {
  switch (uri.scheme) {
    case StreamUri::Scheme::Vmc:
      return make_vmc_encoder(uri, body);
    case StreamUri::Scheme::NatNet:
      return make_natnet_encoder(uri, body);
    case StreamUri::Scheme::Xsens:
      return make_xsens_encoder(uri, body);
    case StreamUri::Scheme::Clip:
      break;
  }
  return Error{"nothing can be sent to a clip; write a file with abrazo export or synth", uri.text};
}

}  // namespace abrazo
