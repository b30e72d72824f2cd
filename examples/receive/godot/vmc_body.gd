# One body that Abrazo sends as VMC to a port, drawn as lines.
# Unity's space is left-handed: X is mirrored, and the body faces +Z.
extends ImmediateGeometry

const PARENT := {
	"Hips": "", "Spine": "Hips", "Chest": "Spine", "UpperChest": "Chest", "Neck": "UpperChest", "Head": "Neck",
	"LeftShoulder": "UpperChest", "LeftUpperArm": "LeftShoulder", "LeftLowerArm": "LeftUpperArm",
	"LeftHand": "LeftLowerArm", "RightShoulder": "UpperChest", "RightUpperArm": "RightShoulder",
	"RightLowerArm": "RightUpperArm", "RightHand": "RightLowerArm", "LeftUpperLeg": "Hips",
	"LeftLowerLeg": "LeftUpperLeg", "LeftFoot": "LeftLowerLeg", "LeftToes": "LeftFoot", "RightUpperLeg": "Hips",
	"RightLowerLeg": "RightUpperLeg", "RightFoot": "RightLowerLeg", "RightToes": "RightFoot"}

var port := 0
var frames := 0
var _peer := PacketPeerUDP.new()
var _root := Transform()
var _local := {}

# False if another program has the port.
func listen(at_port: int) -> bool:
	port = at_port
	return _peer.listen(port, "127.0.0.1") == OK

func _process(_delta: float) -> void:
	var is_whole := false
	while _peer.get_available_packet_count() > 0:
		is_whole = _take(_peer.get_packet()) or is_whole
	if is_whole:
		frames += 1
		_draw_bones(places())

# Bone -> Transform in the world.
func places() -> Dictionary:
	var world := {"": _root}
	for name in PARENT:
		if not _local.has(name):
			continue
		var parent: String = PARENT[name]
		while parent != "" and not _local.has(parent):
			parent = PARENT[parent]
		world[name] = world[parent] * _local[name]
	world.erase("")
	return world

func _draw_bones(world: Dictionary) -> void:
	clear()
	begin(Mesh.PRIMITIVE_LINES)
	for name in world:
		var parent: String = PARENT[name]
		while parent != "" and not world.has(parent):
			parent = PARENT[parent]
		if parent != "":
			add_vertex(world[parent].origin)
			add_vertex(world[name].origin)
	end()

# True when the packet ended a frame: T comes last, once a frame.
func _take(bytes: PoolByteArray) -> bool:
	var packet := StreamPeerBuffer.new()
	packet.big_endian = true
	packet.data_array = bytes
	return _element(packet, bytes.size()) and _local.has("Hips")

func _element(packet: StreamPeerBuffer, end: int) -> bool:
	var address := _text(packet, end)
	if address == "#bundle":
		packet.seek(packet.get_position() + 8)  # the time tag
		var is_whole := false
		while packet.get_position() + 4 <= end:
			var size := packet.get_32()
			var next := packet.get_position() + size
			if size <= 0 or next > end:
				break
			is_whole = _element(packet, next) or is_whole
			packet.seek(next)
		return is_whole
	if address == "/VMC/Ext/T":
		return true
	if address != "/VMC/Ext/Bone/Pos" and address != "/VMC/Ext/Root/Pos":
		return false
	if not _text(packet, end).begins_with(",sfffffff"):
		return false
	var name := _text(packet, end)
	if packet.get_position() + 28 > end:
		return false
	var v := []
	for _i in range(7):
		v.append(packet.get_float())
	var place := Transform(Basis(Quat(v[3], -v[4], -v[5], v[6])), Vector3(-v[0], v[1], v[2]))
	if address == "/VMC/Ext/Root/Pos":
		_root = place
	elif PARENT.has(name):
		_local[name] = place
	return false

# Ends with a zero, and takes a multiple of four bytes.
func _text(packet: StreamPeerBuffer, end: int) -> String:
	var from := packet.get_position()
	var bytes := PoolByteArray()
	while packet.get_position() < end:
		var byte := packet.get_u8()
		if byte == 0:
			break
		bytes.append(byte)
	packet.seek(int(min(from + (bytes.size() + 4) / 4 * 4, end)))
	return bytes.get_string_from_utf8()
