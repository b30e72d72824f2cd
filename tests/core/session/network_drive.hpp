#pragma once

namespace abrazo::test {

/// What files in folders named "netdrive" can do in this program from now on: as on NFS without lockd, or on
/// file systems that map no file for several programs (9p, some SMB).
void network_drive_has(bool locks, bool shared_memory);

}  // namespace abrazo::test
