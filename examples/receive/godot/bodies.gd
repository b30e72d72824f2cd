# A body for each port. Words behind the project: --ports=39540,39550 --seconds=5 (then it says where the bodies are, and ends).
extends Spatial

const VmcBody := preload("res://vmc_body.gd")

var _bodies := []
var _seconds := 0.0

func _ready() -> void:
	var ports := "39540,39550"
	for word in OS.get_cmdline_args():
		if word.begins_with("--ports="):
			ports = word.trim_prefix("--ports=")
		elif word.begins_with("--seconds="):
			_seconds = float(word.trim_prefix("--seconds="))
	for port in ports.split(","):
		var body = VmcBody.new()
		add_child(body)
		_bodies.append(body)
		if not body.listen(int(port)):
			printerr("port ", port, " cannot be opened; close the program that has it")
			get_tree().quit(1)
	if _seconds > 0:
		yield(get_tree().create_timer(_seconds), "timeout")
		for body in _bodies:
			var world = body.places()
			var at = world["Hips"].origin if world.has("Hips") else Vector3()
			print(JSON.print({"port": body.port, "frames": body.frames, "bones": world.size(), "hips": [at.x, at.y, at.z]}))
		get_tree().quit()
