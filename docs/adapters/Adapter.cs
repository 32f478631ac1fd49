// Line protocol of `python -m tools.grade --command ./student`, for the static methods of a class Student.
// Points are System.Numerics.Complex; no contact is null (Complex?); to_polar returns (double, double).
// Build: dotnet new console -n student; put Adapter.cs and Student.cs there in place of Program.cs; dotnet build
// Delete the line of a function that you do not have.
using System;
using System.Globalization;
using System.Linq;
using System.Numerics;

static class Adapter
{
    static Complex Point(double[] a, int i) => new Complex(a[i], a[i + 1]);

    static string Answer(string name, double[] a) => name switch
    {
        "normalize_angle" => Text(Student.normalize_angle(a[0])),
        "add_angles" => Text(Student.add_angles(a[0], a[1])),
        "subtract_angles" => Text(Student.subtract_angles(a[0], a[1])),
        "min_difference" => Text(Student.min_difference(a[0], a[1])),
        "on_left" => Text(Student.on_left(a[0], a[1])),
        "to_polar" => Text(Student.to_polar(Point(a, 0))),
        "to_cartesian" => Text(Student.to_cartesian(a[0], a[1])),
        "closest_point_on_line" => Text(Student.closest_point_on_line(Point(a, 0), Point(a, 2), Point(a, 4))),
        "broad_phase_outcome" => Text(Student.broad_phase_outcome(Point(a, 0), a[2], a[3], a[4], a[5], a[6], a[7])),
        "broad_phase" => Text(Student.broad_phase(Point(a, 0), a[2], a[3], Positions(a), a[4], a[5])),
        "narrow_phase_case_1" => Text(Student.narrow_phase_case_1(Point(a, 0), a[2])),
        "narrow_phase_case_2" => Text(Student.narrow_phase_case_2(Point(a, 0), a[2], a[3], a[4], a[5], a[6], a[7])),
        "collision_response" => Text(Student.collision_response(Point(a, 0), Point(a, 2), Point(a, 4), a[6], a[7])),
        _ => null,
    };

    static (double, double)[] Positions(double[] a) =>
        Enumerable.Range(3, a.Length / 2 - 3).Select(k => (a[2 * k], a[2 * k + 1])).ToArray();

    static string Text(object result) => result switch
    {
        null => "null",
        bool truth => truth ? "true" : "false",
        string word => $"\"{word}\"",
        Complex p => $"[{Text(p.Real)}, {Text(p.Imaginary)}]",
        ValueTuple<double, double> pair => $"[{Text(pair.Item1)}, {Text(pair.Item2)}]",
        double number when double.IsFinite(number) => number.ToString("R", CultureInfo.InvariantCulture),
        _ => "\"not finite\"",
    };

    static void Main()
    {
        while (Console.ReadLine() is string line) // {"function": "to_polar", "arguments": [3.0, 4.0]}
        {
            var numbers = line.Split('[', ']')[1].Split(", ").Select(n => double.Parse(n, CultureInfo.InvariantCulture));
            var answer = Answer(line.Split('"')[3], numbers.ToArray());
            Console.WriteLine(answer is null ? "{\"undefined\": true}" : $"{{\"result\": {answer}}}");
        }
    }
}
