"""The story of story_test.py in Python."""
import windrow

wind = windrow.Wind(windrow.Config(cells=(24, 12, 20), cell_size=0.75, boundaries=windrow.Boundaries.open_over_floor(),
                                   ambient=(3.0, 0.0, 1.0), gusts=windrow.Gusts(intensity=0.2), simd="baseline"))
wind.obstacles.add(windrow.Obstacle(position=(2.0, 1.0, 0.5), shape=windrow.Block((0.5, 1.0, 0.8))))
jet = wind.motors.add(windrow.JetMotor(position=(-3.0, 1.5, 0.0)))
for frame in range(60):
    wind.follow((frame / 20, 1.0, 0.0))
    wind.motors.move(jet, (frame / 16 - 3, 1.5, 0.0))
    wind.advance(1 / 60)
value = 0xcbf29ce484222325
for byte in wind.save():
    value = (value ^ byte) * 0x100000001b3 % 2**64
print(f"{value:016x}")
