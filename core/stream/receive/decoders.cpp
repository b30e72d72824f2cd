#include "core/stream/receive/decoders.hpp"

#include "core/stream/natnet/natnet_decoder.hpp"
#include "core/stream/vmc/vmc_decoder.hpp"
#include "core/stream/xsens/xsens_decoder.hpp"

namespace abrazo {

Result<std::unique_ptr<StreamDecoder>> make_stream_decoder(const StreamUri& uri) {
  switch (uri.scheme) {
    case StreamUri::Scheme::Vmc:
      return make_vmc_decoder(uri);
    case StreamUri::Scheme::NatNet:
      return make_natnet_decoder(uri);
    case StreamUri::Scheme::Xsens:
      return make_xsens_decoder(uri);
    case StreamUri::Scheme::Clip:
      break;
  }
  return Error{"a clip is played, not received; open it as a file", uri.text};
}

}  // namespace abrazo
