"""A virtual partner for close interactions, from recorded pairs and their interaction meshes.

Poses are float64 arrays of 25 joints, x y z in metres, right-handed, Y up, in the order of JOINTS. The guide is
docs/guide/python.md.
"""

from ._abrazo import *  # noqa: F403
from ._abrazo import __version__  # noqa: F401
